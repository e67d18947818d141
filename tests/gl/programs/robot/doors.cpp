#include "tests/gl/programs/robot/functions.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glx.h>
#include <GL/osmesa.h>
#include <X11/Xlib.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace robot {

namespace {

using Function = void (*)();

template <class F>
F of_library(void* library, const char* name) {
    const auto found = reinterpret_cast<F>(dlsym(library, name));
    if (found == nullptr) fail(name);
    return found;
}
void* loaded(const char* name) {
    void* const library = dlopen(name, RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) fail(dlerror());
    return library;
}
#define GW_OF(library, name) of_library<decltype(&::name)>(library, #name)

void open_osmesa() {
    void* const library = loaded("libOSMesa.so.8");
    static std::vector<GLfloat> picture(4 * 320 * 240);
    const OSMesaContext context =
        GW_OF(library, OSMesaCreateContextExt)(OSMESA_RGBA, 24, 8, 0, nullptr);
    if (!GW_OF(library, OSMesaMakeCurrent)(context, picture.data(), GL_FLOAT, 320, 240))
        fail("OSMesaMakeCurrent");
}

/// The first device, and no surface.
void open_egl() {
    void* const library = loaded("libEGL.so.1");
    const auto find = GW_OF(library, eglGetProcAddress);
    const auto devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(find("eglQueryDevicesEXT"));
    const auto open =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(find("eglGetPlatformDisplayEXT"));
    if (devices == nullptr || open == nullptr) fail("eglQueryDevicesEXT");
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    devices(1, &device, &count);
    const EGLDisplay display = open(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (!GW_OF(library, eglInitialize)(display, nullptr, nullptr)) fail("eglInitialize");
    constexpr EGLint wanted[] = {EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_COLOR_BUFFER_TYPE,
                                 EGL_RGB_BUFFER,
                                 EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    GW_OF(library, eglChooseConfig)(display, wanted, &config, 1, &count);
    GW_OF(library, eglBindAPI)(EGL_OPENGL_API);
    const EGLContext context =
        GW_OF(library, eglCreateContext)(display, config, EGL_NO_CONTEXT, nullptr);
    if (!GW_OF(library, eglMakeCurrent)(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        fail("eglMakeCurrent");
}

/// A window that is never shown.
void open_glx() {
    void* const library = loaded("libGL.so.1");
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) fail("XOpenDisplay");
    int wanted[] = {GLX_RGBA, GLX_DEPTH_SIZE, 24, GLX_STENCIL_SIZE, 8, GLX_DOUBLEBUFFER, None};
    XVisualInfo* const visual =
        GW_OF(library, glXChooseVisual)(display, DefaultScreen(display), wanted);
    if (visual == nullptr) fail("glXChooseVisual");
    XSetWindowAttributes attributes{};
    const Window root = DefaultRootWindow(display);
    attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
    const Window window = XCreateWindow(display, root, 0, 0, 320, 240, 0, visual->depth,
                                        InputOutput, visual->visual, CWColormap, &attributes);
    const GLXContext context = GW_OF(library, glXCreateContext)(display, visual, nullptr, True);
    if (!GW_OF(library, glXMakeCurrent)(display, window, context)) fail("glXMakeCurrent");
}

}  // namespace

void fail(std::string_view what) {
    std::fprintf(stderr, "robot: %.*s\n", int(what.size()), what.data());
    std::exit(2);
}

void open_door(const std::string& door) {
    if (door == "osmesa") return open_osmesa();
    if (door == "egl") return open_egl();
    if (door == "glx") return open_glx();
    fail("expected osmesa, egl or glx");
}

void load_functions() {
    using Find = Function (*)(const char*);
    Find find = nullptr;
    for (const char* name : {"eglGetProcAddress", "OSMesaGetProcAddress", "glXGetProcAddressARB"})
        if (find == nullptr) find = reinterpret_cast<Find>(dlsym(RTLD_DEFAULT, name));
    if (find == nullptr) fail("no function that finds functions");
#define GW_FIND(name)                                                    \
    gl.name = reinterpret_cast<decltype(&::gl##name)>(find("gl" #name)); \
    if (gl.name == nullptr) fail("gl" #name);
    ROBOT_FUNCTIONS(GW_FIND)
#undef GW_FIND
    gl.ClipControl = reinterpret_cast<decltype(&::glClipControl)>(find("glClipControl"));
    const auto* const version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    int major = 0, minor = 0;
    if (version == nullptr || std::sscanf(version, "%d.%d", &major, &minor) != 2)
        fail("GL_VERSION");
    if (10 * major + minor < 15) fail("OpenGL version 1.5 or higher required");
    for (const char* needed : {"GL_ARB_framebuffer_object", "GL_ARB_vertex_buffer_object"})
        if (!has_extension(needed)) fail(needed);
}

bool has_extension(std::string_view name) {
    const std::string all =
        std::string(" ") + reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS)) + " ";
    return all.find(" " + std::string(name) + " ") != std::string::npos;
}

}  // namespace robot
