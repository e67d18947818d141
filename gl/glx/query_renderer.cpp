// GLX_MESA_query_renderer: describes the renderer before a context is made. The machine is
// software, the only renderer of every screen.
#include "gl/glx/current.h"
#include "gl/query/strings.h"

#include <unistd.h>

#include <optional>
#include <vector>

namespace {

using namespace gw::gl;

constexpr unsigned no_device = 0xFFFFFFFF;  // no number of PCI

unsigned memory_in_megabytes() {
    return unsigned(std::uint64_t(sysconf(_SC_PHYS_PAGES)) * std::uint64_t(sysconf(_SC_PAGESIZE)) >>
                    20);
}

/// Nothing: no such attribute.
std::optional<std::vector<unsigned>> values_of(int attribute) {
    switch (attribute) {
        case GLX_RENDERER_VENDOR_ID_MESA:
        case GLX_RENDERER_DEVICE_ID_MESA: return {{no_device}};
        case GLX_RENDERER_VERSION_MESA: return {{GW_VERSION_NUMBERS}};
        case GLX_RENDERER_ACCELERATED_MESA: return {{False}};
        case GLX_RENDERER_VIDEO_MEMORY_MESA: return {{memory_in_megabytes()}};
        case GLX_RENDERER_UNIFIED_MEMORY_ARCHITECTURE_MESA: return {{True}};
        case GLX_RENDERER_PREFERRED_PROFILE_MESA:
            return {{GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB}};
        case GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA:
            return {{1, unsigned(offered_minor())}};
        case GLX_RENDERER_OPENGL_CORE_PROFILE_VERSION_MESA:
        case GLX_RENDERER_OPENGL_ES_PROFILE_VERSION_MESA:
        case GLX_RENDERER_OPENGL_ES2_PROFILE_VERSION_MESA: return {{0, 0}};
    }
    return {};
}

Bool query(int attribute, unsigned* out) {
    const auto values = values_of(attribute);
    if (!values) return False;
    for (const unsigned value : *values) *out++ = value;
    return True;
}

const char* name_of(int attribute) {
    if (attribute == GLX_RENDERER_VENDOR_ID_MESA)
        return implementation_string(settings().profile, GL_VENDOR);
    if (attribute == GLX_RENDERER_DEVICE_ID_MESA)
        return implementation_string(settings().profile, GL_RENDERER);
    return nullptr;
}

bool exists(Display* display, int screen, int renderer) {
    return screen >= 0 && screen < ScreenCount(display) && renderer == 0;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

Bool glXQueryRendererIntegerMESA(Display* display, int screen, int renderer, int attribute,
                                 unsigned* value) {
    return exists(display, screen, renderer) ? query(attribute, value) : False;
}

const char* glXQueryRendererStringMESA(Display* display, int screen, int renderer, int attribute) {
    return exists(display, screen, renderer) ? name_of(attribute) : nullptr;
}

Bool glXQueryCurrentRendererIntegerMESA(int attribute, unsigned* value) {
    return glXGetCurrentContext() != nullptr ? query(attribute, value) : False;
}

const char* glXQueryCurrentRendererStringMESA(int attribute) {
    return glXGetCurrentContext() != nullptr ? name_of(attribute) : nullptr;
}

}  // extern "C"
#pragma GCC visibility pop
