// The interface of all hidden-line algorithms. A scene in view goes in; its polygons' sides come
// out, each with its visible parts, with counts and a step log. Each algorithm has a file of its
// name in this folder. Does not draw: lines/draw_lines.h does.
#pragma once

#include "hiddensurface/interface/algorithm.h"

namespace gw::hiddensurface {

/// A part of a line: from .first to .second, both 0 .. 1.
using Part = std::pair<double, double>;

/// A side of a polygon beyond the near plane, and its visible parts.
struct Line {
    std::uint32_t id = 0;  ///< of the polygon, or of one polygon if several have this side
    dvec3 a{0}, b{0};  ///< ends in units of the window grid, not snapped; z as in the depth plane
    std::vector<Part> visible;  ///< ascending, apart; linear in the window
};

/// The counts of all hidden-line algorithms, with one meaning each: one for each question asked.
struct LineCounts {
    std::uint64_t lines = 0;    ///< sides of polygons, each once
    std::uint64_t faces = 0;    ///< hiders: triangles, or whole convex bodies
    std::uint64_t facings = 0;  ///< signs of D_f
    std::uint64_t extents = 0;  ///< two boxes
    /// a line against a plane: of a face, or through the eye and a side
    std::uint64_t planes = 0;
    std::uint64_t crossings = 0;   ///< two lines in the window
    std::uint64_t starts = 0;      ///< lines compared with every face
    std::uint64_t peak_bytes = 0;  ///< peak memory beside the scene and the frame buffer
    std::uint64_t parts = 0;       ///< visible parts
    // Of the machine, and compared with the Z-buffer's hidden-line picture (styles.h).
    std::uint64_t pixels = 0;   ///< drawn
    std::uint64_t missing = 0;  ///< the Z-buffer's pixels without a pixel of ours within one pixel
    std::uint64_t extra = 0;    ///< our pixels without a pixel of the Z-buffer's within one pixel
    bool operator==(const LineCounts&) const = default;
};

struct LineCountName {
    const char* name;
    std::uint64_t LineCounts::*count;
};
/// All counts in this order, for tables, CSV and JSON.
std::span<const LineCountName> line_count_names();

/// All of them, to be watched by a log.
std::vector<WatchedCount> watched(const LineCounts& counts);

struct LineOutput {
    std::vector<Line> lines;
    LineCounts counts;
};

struct LineAlgorithm {
    std::string name;   ///< for the command line
    std::string title;  ///< for people
    std::string claim;  ///< the scenes for which it is right, and its limits
    Growth growth{};
    std::function<LineOutput(const Input&, StepLog&)> run;
};

/// All algorithms, by year.
const std::vector<LineAlgorithm>& line_algorithms();
/// Null if no hidden-line algorithm has this name.
const LineAlgorithm* line_algorithm_named(const std::string& name);

/// The parts of 0 .. 1 outside all of `hidden`, which may overlap and come in any order. Leaves out
/// parts shorter than the rounding of their ends.
std::vector<Part> rest_of(std::vector<Part> hidden);

/// Logs a line's visible parts as a step, with the values that decided them.
void log_line(const Line& line, const char* test, Values values, StepLog& log);

}  // namespace gw::hiddensurface
