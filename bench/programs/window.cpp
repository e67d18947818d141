#include "bench/programs/window.h"

#include "bench/programs/program.h"

#include <GL/glx.h>
#include <X11/Xlib.h>

#include <stdexcept>

namespace gw::bench {

Window::Window(int width, int height) : display_(XOpenDisplay(nullptr)) {
    if (display_ == nullptr) throw std::runtime_error("no X server; expected DISPLAY to name one");
    int wanted[] = {
        GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 1, GLX_DEPTH_SIZE, 16, GLX_STENCIL_SIZE, 1, None};
    XVisualInfo* const visual = glXChooseVisual(display_, DefaultScreen(display_), wanted);
    if (visual == nullptr)
        throw std::runtime_error("no visual with two buffers, depth and stencil");
    const ::Window root = RootWindow(display_, visual->screen);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display_, root, visual->visual, AllocNone);
    window_ =
        XCreateWindow(display_, root, 0, 0, unsigned(width), unsigned(height), 0, visual->depth,
                      InputOutput, visual->visual, CWColormap | CWBorderPixel, &attributes);
    XMapWindow(display_, window_);
    XSync(display_, False);
    glXMakeCurrent(display_, window_, glXCreateContext(display_, visual, nullptr, True));
    window_width = width;
    window_height = height;
}

void Window::swap() const { glXSwapBuffers(display_, window_); }
void Window::wait() const { XSync(display_, False); }

}  // namespace gw::bench
