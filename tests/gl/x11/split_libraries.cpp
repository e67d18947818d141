// A program that is linked with libOpenGL.so.0, libGLX.so.0 and libEGL.so.1 instead of libGL.so.1. It
// draws with a context of GLX, then with one of EGL. Its status is 0 if both worked on the machine.
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glx.h>

#include <array>
#include <cstring>

namespace {

bool draws_on_the_machine() {
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<GLubyte, 4> pixel{};
    glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    const auto* const vendor = reinterpret_cast<const char*>(glGetString(GL_VENDOR));
    return pixel[1] == 255 && std::strcmp(vendor, "GW") == 0;
}

bool draws_by_glx(Display* display) {
    int count = 0;
    GLXFBConfig* const configs =
        glXChooseFBConfig(display, DefaultScreen(display), nullptr, &count);
    if (configs == nullptr) return false;
    const int list[] = {GLX_PBUFFER_WIDTH, 4, GLX_PBUFFER_HEIGHT, 4, 0};
    const GLXPbuffer pbuffer = glXCreatePbuffer(display, configs[0], list);
    const GLXContext context =
        glXCreateNewContext(display, configs[0], GLX_RGBA_TYPE, nullptr, True);
    if (!glXMakeContextCurrent(display, pbuffer, pbuffer, context)) return false;
    const bool drawn = draws_on_the_machine();
    return glXMakeContextCurrent(display, 0, 0, nullptr) != 0 && drawn;
}

bool draws_by_egl(Display* native) {
    const EGLDisplay display = eglGetDisplay(EGLNativeDisplayType(native));
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return false;
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, nullptr, &config, 1, &count) || count != 1) return false;
    const EGLint list[] = {EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, list);
    const EGLContext context = eglCreateContext(display, config, nullptr, nullptr);
    return eglMakeCurrent(display, surface, surface, context) && draws_on_the_machine();
}

}  // namespace

int main() {
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return 1;
    if (!draws_by_glx(display)) return 2;
    return draws_by_egl(display) ? 0 : 3;
}
