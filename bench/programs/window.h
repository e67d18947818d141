// A window of X11 with a current OpenGL context: two buffers, depth and stencil.
#pragma once

struct _XDisplay;

namespace gw::bench {

class Window {
public:
    /// Throws if there is no X server or no such visual. Lives as long as the process.
    Window(int width, int height);
    void swap() const;
    /// Until the server has done everything.
    void wait() const;

private:
    _XDisplay* display_;
    unsigned long window_ = 0;
};

}  // namespace gw::bench
