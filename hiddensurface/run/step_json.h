// A step log as lines of JSON: a header with everything that the steps refer to, a line for each
// step, an end. docs/step_logs.md describes it and steps.schema.json checks it. In these lines
// y counts downwards from the picture's upper edge, in rows and in units of the window grid. Does
// not read steps (read_step.h) or write files.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"
#include "hiddensurface/run/blame.h"

#include <map>

namespace gw::hiddensurface {

/// In the first line of a log.
inline constexpr const char* log_name = "gw hidden steps";
inline constexpr int log_version = 1;

/// From the machine's window grid, whose y counts upwards.
struct PictureGrid {
    int height = 0, unit = 8;  ///< pixels; grid units of a pixel
};
inline PictureGrid grid_of(const Input& input) {
    return {input.view.height, 1 << input.subpixel_bits()};
}

/// One line without its end. `number`: 1, 2, ...
std::string to_json(const Step& step, std::size_t number, const PictureGrid& grid);

/// What the header says about the run.
struct LogSubject {
    std::string algorithm, title;
    bool lines = false;     ///< hidden lines, not surfaces
    bool in_world = false;  ///< polygons are divided in the world, not on the grid
    Level level = Level::Polygon;
};
/// The first line. `colors`: "#rrggbb" by identifier, 0 the background's.
std::string log_header(const Input& input, const LogSubject& subject,
                       const std::map<std::uint32_t, std::string>& colors);

/// The last line: the number of steps and all counts, those of the machine and the comparison too.
/// `blame`: the steps that spoiled pixels.
std::string log_end(std::size_t steps, const Counts& counts, const PictureGrid& grid = {},
                    const std::vector<Blame>& blame = {});
std::string log_end(std::size_t steps, const LineCounts& counts);

/// The whole log: header, steps and this end, a line each.
std::string log_text(const Input& input, const LogSubject& subject, const std::vector<Step>& steps,
                     const std::string& end);

}  // namespace gw::hiddensurface
