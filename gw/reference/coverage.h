// Snapped primitives and the pixels they cover. docs/manual/rasterization.md, "Coverage".
// Does not interpolate, texture or test.
#pragma once

#include "gw/base/types.h"
#include "gw/stages/raster/lines.h"
#include "gw/stages/window.h"

#include <array>
#include <cstdint>
#include <functional>

namespace gw::reference {

/// Canonical, a function of the unordered vertices: counter-clockwise with y up, vertex 0 has the
/// smallest (y, x).
struct SnappedTriangle {
    std::array<std::int64_t, 3> x{}, y{};
    std::array<std::size_t, 3> source{0, 1, 2};  ///< the given vertex of each
    std::int64_t area2 = 0;                      ///< twice the area in square sub-pixels, > 0
    int subpixel_bits = 3;
};

struct SnappedLine : LineEnds {
    bool x_major = true;  ///< |dx| >= |dy|
    int subpixel_bits = 3;
};

/// Twice the signed area; > 0 is counter-clockwise with y up.
std::int64_t area2(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c);

/// Precondition: area2 is not 0. The jitter is added after the snap.
SnappedTriangle snapped_triangle(const std::array<WindowVertex, 3>& v, const JitterState& jitter,
                                 int subpixel_bits);
SnappedLine snapped_line(const WindowVertex& a, const WindowVertex& b, const JitterState& jitter,
                         int subpixel_bits);

using PixelSink = std::function<void(int x, int y)>;

/// The side of a triangle from corner i to the next, at the centre of a pixel.
struct Side {
    std::int64_t dx = 0, dy = 0;
    bool top_left = false;
    std::int64_t e = 0;  ///< inside: >= 0
};
Side side_at(const SnappedTriangle& triangle, std::size_t i, int x, int y);
/// Whether the centre of a pixel is inside by the top-left rule.
bool covers(const SnappedTriangle& triangle, int x, int y);

/// Calls `pixel` for each pixel of `box` whose centre is inside by the top-left rule, row by row
/// from the bottom.
void cover_triangle(const SnappedTriangle& triangle, const Rect& box, const PixelSink& pixel);
/// A line, `rule.width` pixels wide along its minor axis.
void cover_line(const SnappedLine& line, const LineRule& rule, const Rect& box,
                const PixelSink& pixel);
/// Whether a pixel's centre lies between the ends of a line along its major axis, ends included.
bool is_between_ends(const SnappedLine& line, int x, int y);
/// A square of `size` pixels around a snapped point.
void cover_point(std::int64_t x, std::int64_t y, int size, int subpixel_bits, const Rect& box,
                 const PixelSink& pixel);

}  // namespace gw::reference
