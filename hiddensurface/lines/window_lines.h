// A scene's triangles and their sides on the window grid, corners shared: what a line drawing is
// made of after perspective and snap. All lines of sight are parallel to z here, and all numbers
// are integers, so every question below has an exact answer. Does not hide anything.
#pragma once

#include "hiddensurface/lines/line_algorithm.h"

namespace gw::hiddensurface {

struct WindowFace {
    std::array<std::size_t, 3> corner{};  ///< counter-clockwise in the window
    std::uint32_t id = 0;                 ///< of its polygon
};

struct WindowSide {
    std::size_t a = 0, b = 0;  ///< corners, a < b
    std::vector<std::size_t> faces;
    int left = 0, right = 0;  ///< how many of them lie to the left and right of a -> b
    /// a side of a polygon, not made by triangulating or by the near plane
    bool drawn = false;
    std::uint32_t id = 0;  ///< of the polygon; of the first of them

    /// A contour: beyond it more or fewer faces lie than before it.
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
/// Whether their boxes meet in the window, and some of `front` is not behind all of `line`.
bool may_hide(const Box& front, const Box& line);

/// Above 0: p lies behind the face's plane, seen from the eye; 0: on it.
int128 behind(const WindowLines& scene, const WindowFace& face, const GridPoint& p);

/// The part of a -> b that the face hides: inside its outline and behind its plane. A line along
/// the outline counts as lying a little to the left of itself, so that of two faces with a common
/// side one hides it.
std::optional<Part> hidden_part(const WindowLines& scene, const WindowFace& face,
                                const GridPoint& a, const GridPoint& b);

}  // namespace gw::hiddensurface
