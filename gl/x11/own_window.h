// A program's window by a connection of our own, so that another thread can show frames in it while
// the program uses its connection. Any thread may use it, one at a time.
#pragma once

#include "gl/x11/shown_image.h"

#include <memory>

namespace gw::gl::x11 {

class OwnWindow {
public:
    OwnWindow(Display* programs, VisualID visual, XID window);
    ~OwnWindow();
    OwnWindow(const OwnWindow&) = delete;
    OwnWindow& operator=(const OwnWindow&) = delete;

    /// Null: the server accepts no further connection.
    ShownImage* image() { return image_.get(); }

private:
    Display* display_ = nullptr;
    std::unique_ptr<ShownImage> image_;
};

}  // namespace gw::gl::x11
