#include "gl/x11/own_window.h"

namespace gw::gl::x11 {

OwnWindow::OwnWindow(Display* programs, VisualID visual, XID window)
    : display_(XOpenDisplay(DisplayString(programs))) {
    if (display_ == nullptr) return;
    // If the server goes, the program ends by its own connection.
    XSetIOErrorExitHandler(
        display_, [](Display*, void*) {}, nullptr);
    XVisualInfo wanted{};
    wanted.visualid = visual;
    int count = 0;
    XVisualInfo* const found = XGetVisualInfo(display_, VisualIDMask, &wanted, &count);
    if (found == nullptr) return;
    image_ = std::make_unique<ShownImage>(display_, *found, window, 0);
    XFree(found);
}

OwnWindow::~OwnWindow() {
    image_ = nullptr;
    if (display_ != nullptr) XCloseDisplay(display_);
}

}  // namespace gw::gl::x11
