#include "gl/x11/geometry.h"

#include "gl/x11/quiet_errors.h"

#include <algorithm>
#include <tuple>

namespace gw::gl::x11 {

std::optional<Geometry> geometry(Display* display, XID target) {
    QuietErrors quiet(display);
    Window root = 0;
    int x = 0, y = 0;
    unsigned width = 0, height = 0, border = 0, depth = 0;
    if (!XGetGeometry(display, target, &root, &x, &y, &width, &height, &border, &depth)) return {};
    return Geometry{int(width), int(height), int(depth)};
}

std::optional<Geometry> window_geometry(Display* display, XID window) {
    QuietErrors quiet(display);
    XWindowAttributes found{};
    if (!XGetWindowAttributes(display, window, &found)) return {};
    return Geometry{found.width, found.height, found.depth};
}

std::optional<Geometry> pixmap_geometry(Display* display, XID pixmap) {
    if (window_geometry(display, pixmap)) return {};
    return geometry(display, pixmap);
}

std::vector<XVisualInfo> true_color_visuals(Display* display, int screen) {
    XVisualInfo like{};
    like.screen = screen;
    like.c_class = TrueColor;
    int count = 0;
    XVisualInfo* const found =
        XGetVisualInfo(display, VisualScreenMask | VisualClassMask, &like, &count);
    std::vector<XVisualInfo> visuals(found, found + count);
    if (found != nullptr) XFree(found);
    std::erase_if(visuals, [](const XVisualInfo& v) { return v.depth < 15; });
    const VisualID initial = XVisualIDFromVisual(DefaultVisual(display, screen));
    std::stable_sort(visuals.begin(), visuals.end(), [&](const auto& a, const auto& b) {
        return std::tuple(a.visualid != initial, a.depth == 32, a.visualid) <
               std::tuple(b.visualid != initial, b.depth == 32, b.visualid);
    });
    return visuals;
}

}  // namespace gw::gl::x11
