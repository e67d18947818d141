// GLX's functions of versions, configurations and visuals. [GLX 1.4] 3.3.1 to 3.3.3, 3.3.10
#include "gl/glx/displays.h"

#include "gl/context/c_boundary.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>

namespace {

using namespace gw::gl;
using namespace gw::gl::glx;

constexpr const char* glx_extensions =
    "GLX_ARB_create_context GLX_ARB_create_context_profile GLX_ARB_get_proc_address "
    "GLX_ARB_multisample "
    "GLX_EXT_visual_info GLX_EXT_visual_rating GLX_MESA_query_renderer "
    "GLX_OML_swap_method GLX_SGIS_multisample GLX_SGIX_fbconfig GLX_SGI_make_current_read";

const char* string_of(int name) {
    switch (name) {
        case GLX_VENDOR: return "GW";
        case GLX_VERSION: return "1.4";
        case GLX_EXTENSIONS: return glx_extensions;
    }
    return nullptr;
}

/// The configurations as an array that the program frees with XFree; null if there are none.
GLXFBConfig* array_of(const std::vector<Config*>& configs, int* count) {
    *count = int(configs.size());
    if (configs.empty()) return nullptr;
    auto* const array =
        static_cast<GLXFBConfig*>(std::malloc(configs.size() * sizeof(GLXFBConfig)));
    if (array != nullptr) std::memcpy(array, configs.data(), configs.size() * sizeof(GLXFBConfig));
    return array;
}

/// Whether the attribute is one that only configurations have.
bool is_of_configs_only(int name) {
    return name >= GLX_DRAWABLE_TYPE && name <= GLX_MAX_PBUFFER_PIXELS;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

Bool glXQueryExtension(Display* display, int* error_base, int* event_base) {
    return at_c_boundary([&]() -> Bool {
        const ExtensionCodes& codes = codes_of(display);
        if (error_base != nullptr) *error_base = codes.error_base;
        if (event_base != nullptr) *event_base = codes.event_base;
        return True;
    });
}

Bool glXQueryVersion(Display*, int* major, int* minor) {
    if (major != nullptr) *major = 1;
    if (minor != nullptr) *minor = 4;
    return True;
}

const char* glXGetClientString(Display*, int name) { return string_of(name); }

const char* glXQueryServerString(Display* display, int screen, int name) {
    return screen >= 0 && screen < ScreenCount(display) ? string_of(name) : nullptr;
}

const char* glXQueryExtensionsString(Display* display, int screen) {
    return glXQueryServerString(display, screen, GLX_EXTENSIONS);
}

/// Double-buffered ones first: programs look here for the first configuration of a visual, and a
/// visual stands for that one.
GLXFBConfig* glXGetFBConfigs(Display* display, int screen, int* count) {
    return at_c_boundary([&]() -> GLXFBConfig* {
        std::vector<Config*> all;
        for (Config& config : configs_of(display, screen)) all.push_back(&config);
        std::stable_partition(all.begin(), all.end(), std::mem_fn(&Config::double_buffered));
        return array_of(all, count);
    });
}

GLXFBConfig* glXChooseFBConfig(Display* display, int screen, const int* list, int* count) {
    return at_c_boundary([&]() -> GLXFBConfig* {
        *count = 0;
        const auto found = matching(configs_of(display, screen), list);
        return found ? array_of(*found, count) : nullptr;
    });
}

int glXGetFBConfigAttrib(Display* display, GLXFBConfig config, int name, int* value) {
    return at_c_boundary([&]() -> int {
        if (!is_config(display, config)) return GLX_BAD_VALUE;
        const std::optional<int> has = attribute(*config, name);
        if (!has) return GLX_BAD_ATTRIBUTE;
        *value = *has;
        return Success;
    });
}

XVisualInfo* glXGetVisualFromFBConfig(Display* display, GLXFBConfig config) {
    return at_c_boundary([&]() -> XVisualInfo* {
        return is_config(display, config) ? chosen_visual(display, *config) : nullptr;
    });
}

XVisualInfo* glXChooseVisual(Display* display, int screen, int* list) {
    return at_c_boundary([&]() -> XVisualInfo* {
        const auto attributes = list_of_visual_attributes(list);
        if (!attributes) return nullptr;
        const auto found = matching(configs_of(display, screen), attributes->data());
        return found && !found->empty() ? chosen_visual(display, *found->front()) : nullptr;
    });
}

int glXGetConfig(Display* display, XVisualInfo* visual, int name, int* value) {
    return at_c_boundary([&]() -> int {
        if (visual == nullptr) return GLX_BAD_VISUAL;
        if (visual->screen < 0 || visual->screen >= ScreenCount(display)) return GLX_BAD_SCREEN;
        const Config* const config = config_of_visual(display, *visual);
        if (name == GLX_USE_GL) return *value = config != nullptr, Success;
        if (config == nullptr) return GLX_BAD_VISUAL;
        const std::optional<int> has = attribute(*config, name);
        if (!has || is_of_configs_only(name)) return GLX_BAD_ATTRIBUTE;
        *value = *has;
        return Success;
    });
}

int glXGetFBConfigAttribSGIX(Display* display, GLXFBConfig config, int name, int* value) {
    return glXGetFBConfigAttrib(display, config, name, value);
}

GLXFBConfig* glXChooseFBConfigSGIX(Display* display, int screen, int* list, int* count) {
    return glXChooseFBConfig(display, screen, list, count);
}

XVisualInfo* glXGetVisualFromFBConfigSGIX(Display* display, GLXFBConfig config) {
    return glXGetVisualFromFBConfig(display, config);
}

GLXFBConfig glXGetFBConfigFromVisualSGIX(Display* display, XVisualInfo* visual) {
    return at_c_boundary([&]() -> GLXFBConfig {
        return visual != nullptr ? config_of_visual(display, *visual) : nullptr;
    });
}

}  // extern "C"
#pragma GCC visibility pop
