// What the hidden-line algorithms have in common: a scene in view goes in; its polygons' sides come
// out, each with the parts of it that can be seen, counts and a step log. One file pair per
// algorithm in this folder.
// Does not draw: lines/draw_lines.h does.
#pragma once

#include "hiddensurface/run/algorithm.h"

namespace gw::hiddensurface {

/// A part of a line: from .first to .second, both 0 .. 1.
using Part = std::pair<double, double>;

/// A side of a polygon, before the near plane, and what is seen of it.
struct Line {
    std::uint32_t id = 0;  ///< of the polygon; of one of them where several have this side
    /// on the window grid, z as in the depth plane; may lie between its places
    dvec3 a{0}, b{0};
    std::vector<Part> visible;  ///< ascending, apart; linear in the window
};

/// What every hidden-line algorithm counts, and means the same by: one for each question asked.
struct LineCounts {
    std::uint64_t lines = 0;    ///< sides of polygons, each once
    std::uint64_t faces = 0;    ///< what may hide them: triangles, or whole convex bodies
    std::uint64_t facings = 0;  ///< signs of D_f
    std::uint64_t extents = 0;  ///< two boxes
    /// a line against a plane: of a face, or through the eye and a side
    std::uint64_t planes = 0;
    std::uint64_t crossings = 0;   ///< two lines in the window
    std::uint64_t starts = 0;      ///< lines compared with every face
    std::uint64_t peak_bytes = 0;  ///< memory beside the scene and the frame buffer, at most
    std::uint64_t parts = 0;       ///< that are visible
    // Of the machine, and beside the Z-buffer's hidden-line picture (styles.h).
    std::uint64_t pixels = 0;   ///< drawn
    std::uint64_t missing = 0;  ///< of the Z-buffer's pixels: no pixel of this picture within one
    /// of this picture's pixels: no pixel of the Z-buffer's within one
    std::uint64_t extra = 0;
    bool operator==(const LineCounts&) const = default;
};

struct LineCountName {
    const char* name;
    std::uint64_t LineCounts::*count;
};
/// All of them in this order, for tables, CSV and JSON.
std::span<const LineCountName> line_count_names();

struct LineOutput {
    std::vector<Line> lines;
    LineCounts counts;
};

struct LineAlgorithm {
    std::string name;   ///< for the command line
    std::string title;  ///< for people
    std::string claim;  ///< what it is right about, and what it does not claim
    Growth growth{};
    std::function<LineOutput(const Input&, StepLog&)> run;
};

/// By year.
const std::vector<LineAlgorithm>& line_algorithms();
/// None where no hidden-line algorithm has this name.
const LineAlgorithm* line_algorithm_named(const std::string& name);

/// Parts of 0 .. 1 that are in none of `hidden` (in any order, overlapping or not); parts shorter
/// than the rounding of their ends are left out.
std::vector<Part> rest_of(std::vector<Part> hidden);

/// A step of the log: what is seen of a line.
void log_line(const Line& line, StepLog& log);

}  // namespace gw::hiddensurface
