// What the server says of a window or pixmap.
#pragma once

#include "gl/x11/x11.h"

#include <optional>
#include <vector>

namespace gw::gl::x11 {

struct Geometry {
    int width = 0, height = 0, depth = 0;
};
/// None if there is no such window or pixmap.
std::optional<Geometry> geometry(Display* display, XID target);
/// None if there is no such window.
std::optional<Geometry> window_geometry(Display* display, XID window);
/// None if there is no such pixmap.
std::optional<Geometry> pixmap_geometry(Display* display, XID pixmap);

/// The TrueColor visuals of a screen that can be drawn to: the screen's default visual first, those
/// with an alpha channel last.
std::vector<XVisualInfo> true_color_visuals(Display* display, int screen);

}  // namespace gw::gl::x11
