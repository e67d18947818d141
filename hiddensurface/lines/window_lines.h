// A scene's triangles and their sides on the window grid, with shared corners, after perspective
// and snap. All lines of sight are parallel to z here, and all numbers are integers, so every
// question below has an exact answer. Does not hide anything.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

struct WindowFace {
    std::array<std::size_t, 3> corner{};  ///< counter-clockwise in the window
    std::uint32_t id = 0;                 ///< of its polygon
};

struct WindowSide {
    std::size_t a = 0, b = 0;  ///< corners, a < b
    std::vector<std::size_t> faces;
    int left = 0, right = 0;  ///< the number of faces to the left and right of a -> b
    bool drawn = false;    ///< a side of a polygon, not made by triangulation or by the near plane
    std::uint32_t id = 0;  ///< of the first polygon that has it

    /// A contour has more or fewer faces on one side than on the other.
    bool is_contour() const { return left != right; }
};

struct WindowLines {
    std::vector<GridPoint> corners;
    std::vector<WindowFace> faces;
    std::vector<WindowSide> sides;
    std::vector<std::vector<std::size_t>> faces_at, sides_at;  ///< of each corner
};
WindowLines window_lines(const Input& input);

struct Box {
    GridPoint low, high;
};
Box box_of(std::initializer_list<GridPoint> points);
/// Whether the boxes meet in the window, and `front` is not behind all of `line`.
bool may_hide(const Box& front, const Box& line);

/// Above 0: p lies behind the face's plane, seen from the eye; 0: on it.
int128 behind(const WindowLines& scene, const WindowFace& face, const GridPoint& p);

/// The part of a -> b that the face hides: inside its outline and behind its plane. A line along the
/// outline counts as lying slightly to its left, so that one of two faces with a common side hides
/// it.
std::optional<Part> hidden_part(const WindowLines& scene, const WindowFace& face,
                                const GridPoint& a, const GridPoint& b);

}  // namespace gw::hiddensurface
