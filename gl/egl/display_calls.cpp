// EGL's functions of displays, configurations and strings. [EGL 1.5] 3.1 to 3.4
#include "gl/egl/displays.h"
#include "gl/egl/failure.h"
#include "gl/x11/geometry.h"

#include <algorithm>
#include <utility>

namespace {

using namespace gw::gl;
using namespace gw::gl::egl;

constexpr const char* client_extensions =
    "EGL_EXT_client_extensions EGL_EXT_device_base EGL_EXT_device_enumeration "
    "EGL_EXT_device_query EGL_EXT_platform_base EGL_EXT_platform_device EGL_EXT_platform_x11 "
    "EGL_KHR_client_get_all_proc_addresses EGL_KHR_platform_x11 EGL_MESA_platform_surfaceless";
constexpr const char* display_extensions =
    "EGL_KHR_create_context EGL_KHR_get_all_proc_addresses EGL_KHR_surfaceless_context";

const char* string_of(EGLint name, const char* extensions) {
    switch (name) {
        case EGL_CLIENT_APIS: return "OpenGL";
        case EGL_EXTENSIONS: return extensions;
        case EGL_VENDOR: return "GW";
        case EGL_VERSION: return "1.5";
    }
    throw Failure{EGL_BAD_PARAMETER};
}

/// Stores as many configurations as the array holds.
void store_configs(const std::vector<Config*>& found, EGLConfig* array, EGLint size,
                   EGLint* count) {
    if (count == nullptr) throw Failure{EGL_BAD_PARAMETER};
    *count = EGLint(found.size());
    if (array == nullptr) return;
    *count = std::min(*count, std::max(size, 0));
    std::copy_n(found.begin(), *count, array);
}

/// MATCH_NATIVE_PIXMAP's pixmap in a list; 0: none.
XID pixmap_to_match(const EGLint* list) {
    XID pixmap = 0;
    for (; list != nullptr && list[0] != EGL_NONE; list += 2)
        if (list[0] == EGL_MATCH_NATIVE_PIXMAP && list[1] != EGL_NONE) pixmap = XID(list[1]);
    return pixmap;
}

void keep_configs_for_pixmap(const EglDisplay& display, XID pixmap, std::vector<Config*>& configs) {
    if (pixmap == 0) return;
    const auto size = display.native ? x11::pixmap_geometry(display.native, pixmap) : std::nullopt;
    if (!size) throw Failure{EGL_BAD_NATIVE_PIXMAP};
    std::erase_if(configs, [&](const Config* c) { return c->visual.depth != size->depth; });
}

/// The display of a platform; null if the platform is not there.
EGLDisplay platform_display(EGLenum platform, void* native, int screen) {
    if (platform == EGL_PLATFORM_X11_KHR)
        return &display_for(Platform::X11, static_cast<Display*>(native), screen);
    if (platform == EGL_PLATFORM_SURFACELESS_MESA && native == nullptr)
        return &display_for(Platform::Surfaceless, nullptr);
    if (platform == EGL_PLATFORM_DEVICE_EXT && native == machine_device())
        return &display_for(Platform::Device, nullptr);
    throw Failure{EGL_BAD_PARAMETER};
}

template <class Number>
EGLDisplay platform_display_of_list(EGLenum platform, void* native, const Number* list) {
    int screen = -1;
    for (; list != nullptr && list[0] != EGL_NONE; list += 2) {
        const bool is_screen =
            platform == EGL_PLATFORM_X11_KHR && list[0] == EGL_PLATFORM_X11_SCREEN_KHR;
        if (!is_screen || list[1] < 0) throw Failure{EGL_BAD_ATTRIBUTE};
        screen = int(list[1]);
    }
    return platform_display(platform, native, screen);
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

EGLint eglGetError() { return std::exchange(binding().error, EGL_SUCCESS); }

EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
    return carried_out([&]() -> EGLDisplay {
        if (native == EGL_DEFAULT_DISPLAY) return &display_for(default_platform(), nullptr);
        return &display_for(Platform::X11, static_cast<Display*>(native));
    });
}

EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* list) {
    return carried_out([&] { return platform_display_of_list(platform, native, list); });
}

EGLDisplay eglGetPlatformDisplayEXT(EGLenum platform, void* native, const EGLint* list) {
    return carried_out([&] { return platform_display_of_list(platform, native, list); });
}

EGLBoolean eglInitialize(EGLDisplay handle, EGLint* major, EGLint* minor) {
    return carried_out([&]() -> EGLBoolean {
        initialize(known_display(handle));
        if (major != nullptr) *major = 1;
        if (minor != nullptr) *minor = 5;
        return EGL_TRUE;
    });
}

EGLBoolean eglTerminate(EGLDisplay handle) {
    return carried_out([&]() -> EGLBoolean {
        terminate(known_display(handle));
        return EGL_TRUE;
    });
}

const char* eglQueryString(EGLDisplay handle, EGLint name) {
    return carried_out([&]() -> const char* {
        // [EGL 1.5] 3.3: what does not depend on a display.
        if (handle == EGL_NO_DISPLAY && (name == EGL_EXTENSIONS || name == EGL_VERSION))
            return string_of(name, client_extensions);
        initialized_display(handle);
        return string_of(name, display_extensions);
    });
}

EGLBoolean eglGetConfigs(EGLDisplay handle, EGLConfig* array, EGLint size, EGLint* count) {
    return carried_out([&]() -> EGLBoolean {
        std::vector<Config*> all;
        for (Config& config : initialized_display(handle).configs) all.push_back(&config);
        store_configs(all, array, size, count);
        return EGL_TRUE;
    });
}

EGLBoolean eglChooseConfig(EGLDisplay handle, const EGLint* list, EGLConfig* array, EGLint size,
                           EGLint* count) {
    return carried_out([&]() -> EGLBoolean {
        EglDisplay& display = initialized_display(handle);
        std::vector<Config*> found = matching(display.configs, list);
        keep_configs_for_pixmap(display, pixmap_to_match(list), found);
        store_configs(found, array, size, count);
        return EGL_TRUE;
    });
}

EGLBoolean eglGetConfigAttrib(EGLDisplay handle, EGLConfig config, EGLint name, EGLint* value) {
    return carried_out([&]() -> EGLBoolean {
        const auto has = attribute(config_of(initialized_display(handle), config), name);
        if (!has) throw Failure{EGL_BAD_ATTRIBUTE};
        if (value == nullptr) throw Failure{EGL_BAD_PARAMETER};
        *value = *has;
        return EGL_TRUE;
    });
}

}  // extern "C"
#pragma GCC visibility pop
