// An algorithm in any language: its steps come as lines of JSON, in the form of a step log, and are
// drawn as if an algorithm here had made them. docs/step_logs.md describes the lines. Does not
// read files.
#pragma once

#include "hiddensurface/run/compare.h"

#include <map>
#include <string>

namespace gw::hiddensurface {

/// What such an algorithm works on: the polygons of a log's header, with the size, the unit and the
/// view. `colors` as for log_header.
std::string polygons_json(const Input& input, const std::map<std::uint32_t, std::string>& colors);

struct Play {
    std::vector<Step> steps;    ///< a drawn piece has its pixels
    std::vector<Piece> pieces;  ///< drawn, with the sides that the program's cuts made
    Level level = Level::Polygon;
};
/// The steps of a text, one a line. Throws Error "FILE:LINE: what; expected what".
Play read_play(const Input& input, const std::string& file, const std::string& text);

/// Draws and logs the steps. Counts sorts, splits and spans; takes other counts from the steps.
Algorithm played(Play play);

/// A polygon's pixels in a compared picture.
struct PolygonGrade {
    std::uint32_t id = 0;
    std::uint64_t expected = 0, shown = 0;  ///< pixels of the Z-buffer's picture, of this one
    std::uint64_t missing = 0, extra = 0;   ///< wrong pixels: of the polygon, or that show it
};
/// One for each polygon in either picture, by identifier; 0 is the background.
std::vector<PolygonGrade> grades_of(const Result& result,
                                    const std::vector<std::uint32_t>& z_buffer);

}  // namespace gw::hiddensurface
