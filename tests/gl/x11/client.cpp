#include "tests/gl/x11/client.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace {

std::mutex error_mutex;
std::vector<int> errors;

int collect_error(Display*, XErrorEvent* event) {
    const std::lock_guard lock(error_mutex);
    errors.push_back(event->error_code);
    return 0;
}

}  // namespace

bool Shown::is_all(unsigned long pixel) const {
    return std::all_of(pixels.begin(), pixels.end(), [&](auto p) { return p == pixel; });
}

void Glx::SetUp() {
    errors.clear();
    XSetErrorHandler(&collect_error);
    display = XOpenDisplay(nullptr);
    ASSERT_NE(display, nullptr) << "DISPLAY has no server: run by tests/gl/x11/under_xvfb";
}

void Glx::TearDown() {
    if (display == nullptr) return;
    glXMakeCurrent(display, 0, nullptr);
    XCloseDisplay(display);
    EXPECT_EQ(errors, std::vector<int>());
}

GLXFBConfig Glx::config(bool double_buffered) const {
    const int list[] = {GLX_DOUBLEBUFFER, double_buffered, 0};
    int count = 0;
    GLXFBConfig* const found = glXChooseFBConfig(display, DefaultScreen(display), list, &count);
    if (found == nullptr) return nullptr;
    const GLXFBConfig first = found[0];
    XFree(found);
    return first;
}

Window Glx::make_window(GLXFBConfig config, int width, int height) {
    XVisualInfo* const visual = glXGetVisualFromFBConfig(display, config);
    const Window root = RootWindow(display, visual->screen);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
    const Window made =
        XCreateWindow(display, root, 0, 0, unsigned(width), unsigned(height), 0, visual->depth,
                      InputOutput, visual->visual, CWBorderPixel | CWColormap, &attributes);
    XFree(visual);
    XMapWindow(display, made);
    XSync(display, False);
    return made;
}

GLXContext Glx::make_current(bool double_buffered, int width, int height) {
    const GLXFBConfig with = config(double_buffered);
    window = make_window(with, width, height);
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    EXPECT_TRUE(glXMakeCurrent(display, window, context));
    return context;
}

Pixmap Glx::make_pixmap(int width, int height) const {
    return XCreatePixmap(display, DefaultRootWindow(display), unsigned(width), unsigned(height),
                         unsigned(DefaultDepth(display, DefaultScreen(display))));
}

void Glx::fill(Drawable drawable, unsigned long pixel, int width, int height) const {
    const GC gc = XCreateGC(display, drawable, 0, nullptr);
    XSetForeground(display, gc, pixel);
    XFillRectangle(display, drawable, gc, 0, 0, unsigned(width), unsigned(height));
    XFreeGC(display, gc);
}

Shown Glx::shown(Drawable drawable, int width, int height) const {
    Shown out{width, height, {}};
    XImage* const image =
        XGetImage(display, drawable, 0, 0, unsigned(width), unsigned(height), AllPlanes, ZPixmap);
    if (image == nullptr) return out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out.pixels.push_back(XGetPixel(image, x, y));
    XDestroyImage(image);
    return out;
}

unsigned long Glx::pixel(bool r, bool g, bool b) const {
    const Visual* const visual = DefaultVisual(display, DefaultScreen(display));
    return (r ? visual->red_mask : 0) | (g ? visual->green_mask : 0) | (b ? visual->blue_mask : 0);
}

std::vector<int> Glx::errors_of(const std::function<void()>& action) const {
    XSync(display, False);
    errors.clear();
    action();
    XSync(display, False);
    return std::exchange(errors, {});
}

int Glx::glx_error(int number) const {
    int error_base = 0, event_base = 0;
    glXQueryExtension(display, &error_base, &event_base);
    return error_base + number;
}

void clear_to(float r, float g, float b) {
    glClearColor(r, g, b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}
