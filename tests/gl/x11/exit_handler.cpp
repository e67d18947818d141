// A program whose exit handler leaves and destroys its context, after the main thread's variables are
// gone. Its status is 0 if that worked.
#include <GL/glx.h>

#include <cstdlib>

namespace {

Display* display = nullptr;
GLXContext context = nullptr;

void leave() {
    if (glXMakeCurrent(display, None, nullptr) == 0) std::_Exit(2);
    glXDestroyContext(display, context);
    XCloseDisplay(display);
}

}  // namespace

int main() {
    display = XOpenDisplay(nullptr);
    if (display == nullptr) return 1;
    int list[] = {GLX_RGBA, GLX_DOUBLEBUFFER, None};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), list);
    if (visual == nullptr) return 1;
    const Window window =
        XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 40, 30, 0, 0, 0);
    context = glXCreateContext(display, visual, nullptr, 1);
    if (glXMakeCurrent(display, window, context) == 0) return 1;
    glClear(GL_COLOR_BUFFER_BIT);
    for (int frame = 0; frame < 40; ++frame) {  // the last is still being drawn
        glClear(GL_COLOR_BUFFER_BIT);
        glXSwapBuffers(display, window);
    }
    std::atexit(leave);
    std::exit(0);
}
