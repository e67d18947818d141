// A convex face in the window, exactly: sides and plane in integers, evaluated at the centres of
// pixels. They are linear in x and y. So an answer that holds at the four corner pixels of a window,
// or at both ends of a span, holds in between. Does not draw.
#pragma once

#include "hiddensurface/interface/algorithm.h"

namespace gw::hiddensurface {

/// a x + b y + c >= 0: the centre of pixel x, y is inside, or on a left or top side.
struct Side {
    std::int64_t a = 0, b = 0, c = 0;
    std::int64_t at(int x, int y) const { return a * x + b * y + c; }
};

/// The depth (x px + y py + c) / n at the centre of pixel px, py, not rounded; n > 0.
struct ExactPlane {
    int128 x = 0, y = 0, c = 0, n = 1;
    int128 scaled(int px, int py) const { return x * px + y * py + c; }
};

/// A facet of a polygon if it is convex on the grid, else one of its triangles.
struct Face {
    std::size_t polygon = 0;         ///< index
    std::string name;                ///< in step logs
    std::size_t place = 0;           ///< in the drawing order: of equal depths the first is seen
    std::vector<GridPoint> corners;  ///< counter-clockwise
    std::vector<Side> sides;         ///< from corner i to corner i + 1
    ExactPlane plane;
    Rect bounds;                             ///< pixels that it may cover
    std::int64_t nearest = 0, farthest = 0;  ///< z of its corners
};

/// The faces of all polygons in the window, in the machine's order.
std::vector<Face> faces_of(const Input& input);

bool covers(const Face& face, int x, int y);

enum class Cover { Disjoint, Intersects, Surrounds };
/// The answer may be Intersects for a window that only two sides together keep outside.
Cover cover_of(const Face& face, const Rect& window);

/// z at pixel x, y, for logs: rounded to double.
inline double depth_at(const Face& face, int x, int y) {
    return double(face.plane.scaled(x, y)) / double(face.plane.n);
}

/// Sign of z_a - z_b at pixel x, y.
int depth_order(const Face& a, const Face& b, int x, int y);
/// a is nearer than b at pixel x, y, or as near and drawn first, as in the Z-buffer but for ties.
bool is_nearer(const Face& a, const Face& b, int x, int y);
/// The same at every pixel of the window: compares at the four corners, stopping at the first
/// failure.
bool is_nearer(const Face& a, const Face& b, const Rect& window, std::uint64_t& compared);

/// The first pixel of the run at which a is nearer than b, by halving. a must not be nearer at the
/// first pixel, and must be at the last.
int first_nearer(const Face& a, const Face& b, const Run& run, std::uint64_t& compared);

/// The face's pixels of row y from x0 up to x1; empty: x0 >= x1.
Run run_of(const Face& face, int y, int x0, int x1);

}  // namespace gw::hiddensurface
