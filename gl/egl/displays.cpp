#include "gl/egl/displays.h"

#include "gl/egl/failure.h"
#include "gl/record/recorder.h"
#include "gl/x11/extension.h"
#include "gl/x11/quiet_errors.h"

#include <cstdlib>
#include <mutex>
#include <string_view>
#include <utility>

namespace gw::gl::egl {

namespace {

struct KnownDisplays {
    /// Guards all that hangs on the displays. No request of X11 is made while it is held.
    std::recursive_mutex mutex;
    std::deque<EglDisplay> displays;
};

/// Never destroyed: programs call EGL from their own exit handlers.
KnownDisplays& known() {
    static auto* const displays = new KnownDisplays;
    return *displays;
}

auto exclusive() { return std::unique_lock(known().mutex); }

/// The program closes the X display.
int forget_native(Display* native, XExtCodes*) {
    const auto lock = exclusive();
    for (EglDisplay& display : known().displays) {
        if (display.native != native) continue;
        for (const auto& [handle, surface] : display.surfaces) surface->lose_display();
        terminate(display);
        display.configs.clear();
    }
    return 0;
}

/// The server of a display without a native one: opened once, never closed.
Display* default_server() {
    static Display* const server = XOpenDisplay(nullptr);
    return server;
}

std::deque<Config> make_configs(EglDisplay& display) {
    if (display.platform != Platform::X11) return make_surfaceless_configs();
    if (display.native == nullptr) display.native = default_server();
    if (display.native == nullptr) throw Failure{EGL_NOT_INITIALIZED};
    const x11::LockedDisplay locked(display.native);
    if (display.screen < 0) display.screen = DefaultScreen(display.native);
    if (display.screen >= ScreenCount(display.native)) throw Failure{EGL_NOT_INITIALIZED};
    x11::call_at_close(display.native, &forget_native);
    return make_x11_configs(display.native, display.screen);
}

template <class Object>
Object found(const std::map<void*, Object>& objects, void* handle, EGLint error) {
    const auto lock = exclusive();
    const auto place = objects.find(handle);
    if (place == objects.end()) throw Failure{error};
    return place->second;
}

}  // namespace

EglDisplay& display_for(Platform platform, Display* native, int screen) {
    const auto lock = exclusive();
    if (platform == Platform::X11 && native == nullptr) native = default_server();
    if (native != nullptr && screen < 0) screen = DefaultScreen(native);
    for (EglDisplay& display : known().displays)
        if (display.platform == platform && display.native == native && display.screen == screen)
            return display;
    return known().displays.emplace_back(EglDisplay{platform, native, screen});
}

Platform default_platform() {
    const char* const wanted = std::getenv("EGL_PLATFORM");
    if (wanted != nullptr && std::string_view(wanted) == "surfaceless")
        return Platform::Surfaceless;
    return default_server() != nullptr ? Platform::X11 : Platform::Surfaceless;
}

void initialize(EglDisplay& display) {
    if (display.is_initialized) return;
    start_recording();
    if (display.configs.empty()) {
        std::deque<Config> configs = make_configs(display);
        const auto lock = exclusive();
        if (display.configs.empty()) display.configs = std::move(configs);
    }
    display.is_initialized = true;
}

void terminate(EglDisplay& display) {
    const auto lock = exclusive();
    display.is_initialized = false;
    display.surfaces.clear();
    display.contexts.clear();
    display.syncs.clear();
}

EglDisplay& known_display(EGLDisplay handle) {
    const auto lock = exclusive();
    for (EglDisplay& display : known().displays)
        if (&display == handle) return display;
    throw Failure{EGL_BAD_DISPLAY};
}

EglDisplay& initialized_display(EGLDisplay handle) {
    EglDisplay& display = known_display(handle);
    if (!display.is_initialized) throw Failure{EGL_NOT_INITIALIZED};
    return display;
}

Config& config_of(EglDisplay& display, EGLConfig handle) {
    const auto lock = exclusive();
    for (Config& config : display.configs)
        if (&config == handle) return config;
    throw Failure{EGL_BAD_CONFIG};
}

std::shared_ptr<Surface> surface_of(EglDisplay& display, EGLSurface handle) {
    return found(display.surfaces, handle, EGL_BAD_SURFACE);
}

std::shared_ptr<ClientContext> context_of(EglDisplay& display, EGLContext handle) {
    return found(display.contexts, handle, EGL_BAD_CONTEXT);
}

EGLSurface keep(EglDisplay& display, std::shared_ptr<Surface> surface) {
    const auto lock = exclusive();
    const EGLSurface handle = surface.get();
    display.surfaces[handle] = std::move(surface);
    return handle;
}

EGLContext keep(EglDisplay& display, std::shared_ptr<ClientContext> context) {
    const auto lock = exclusive();
    const EGLContext handle = context.get();
    display.contexts[handle] = std::move(context);
    return handle;
}

EGLSync keep_new_sync(EglDisplay& display) {
    static std::uintptr_t count = 0;
    const auto lock = exclusive();
    return *display.syncs.insert(reinterpret_cast<EGLSync>(++count)).first;
}

bool has_surface_for(const EglDisplay& display, XID target) {
    const auto lock = exclusive();
    for (const auto& [handle, surface] : display.surfaces)
        if (surface->target() == target && surface->kind() != Surface::Kind::Pbuffer) return true;
    return false;
}

void forget_surface(EglDisplay& display, EGLSurface handle) {
    // Destroyed after the lock is gone.
    const std::shared_ptr<Surface> forgotten = surface_of(display, handle);
    const auto lock = exclusive();
    display.surfaces.erase(handle);
}

void forget_context(EglDisplay& display, EGLContext handle) {
    const std::shared_ptr<ClientContext> forgotten = context_of(display, handle);
    const auto lock = exclusive();
    display.contexts.erase(handle);
}

void check_sync(const EglDisplay& display, EGLSync handle) {
    const auto lock = exclusive();
    if (!display.syncs.contains(handle)) throw Failure{EGL_BAD_PARAMETER};
}

void forget_sync(EglDisplay& display, EGLSync handle) {
    const auto lock = exclusive();
    if (display.syncs.erase(handle) == 0) throw Failure{EGL_BAD_PARAMETER};
}

}  // namespace gw::gl::egl
