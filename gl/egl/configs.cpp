#include "gl/egl/configs.h"

#include "gl/drawable/settings.h"
#include "gl/drawable/window_samples.h"
#include "gl/egl/failure.h"
#include "gl/x11/criteria.h"
#include "gl/x11/geometry.h"

#include <array>
#include <iterator>
#include <set>

namespace gw::gl::egl {

namespace {

using x11::Criterion;
using x11::Match;

/// [EGL 1.5] table 3.4
constexpr Criterion criteria[] = {
    {EGL_BUFFER_SIZE, Match::AtLeast, 0},
    {EGL_RED_SIZE, Match::AtLeast, 0},
    {EGL_GREEN_SIZE, Match::AtLeast, 0},
    {EGL_BLUE_SIZE, Match::AtLeast, 0},
    {EGL_LUMINANCE_SIZE, Match::AtLeast, 0},
    {EGL_ALPHA_SIZE, Match::AtLeast, 0},
    {EGL_ALPHA_MASK_SIZE, Match::AtLeast, 0},
    {EGL_BIND_TO_TEXTURE_RGB, Match::Exact},
    {EGL_BIND_TO_TEXTURE_RGBA, Match::Exact},
    {EGL_COLOR_BUFFER_TYPE, Match::Exact, EGL_RGB_BUFFER},
    {EGL_CONFIG_CAVEAT, Match::Exact},
    {EGL_CONFORMANT, Match::Mask, 0},
    {EGL_DEPTH_SIZE, Match::AtLeast, 0},
    {EGL_LEVEL, Match::Exact, 0},
    {EGL_MATCH_NATIVE_PIXMAP, Match::Ignored, EGL_NONE},
    {EGL_MAX_PBUFFER_WIDTH, Match::Ignored},
    {EGL_MAX_PBUFFER_HEIGHT, Match::Ignored},
    {EGL_MAX_PBUFFER_PIXELS, Match::Ignored},
    {EGL_MAX_SWAP_INTERVAL, Match::Exact},
    {EGL_MIN_SWAP_INTERVAL, Match::Exact},
    {EGL_NATIVE_RENDERABLE, Match::Exact},
    {EGL_NATIVE_VISUAL_ID, Match::Ignored},
    {EGL_NATIVE_VISUAL_TYPE, Match::Exact},
    {EGL_RENDERABLE_TYPE, Match::Mask, EGL_OPENGL_ES_BIT},
    {EGL_SAMPLE_BUFFERS, Match::AtLeast, 0},
    {EGL_SAMPLES, Match::AtLeast, 0},
    {EGL_STENCIL_SIZE, Match::AtLeast, 0},
    {EGL_SURFACE_TYPE, Match::Mask, EGL_WINDOW_BIT},
    {EGL_TRANSPARENT_TYPE, Match::Exact, EGL_NONE},
    {EGL_TRANSPARENT_RED_VALUE, Match::Ignored},
    {EGL_TRANSPARENT_GREEN_VALUE, Match::Ignored},
    {EGL_TRANSPARENT_BLUE_VALUE, Match::Ignored},
    {EGL_CONFIG_ID, Match::Exact},
};
constexpr std::size_t criterion_count = std::size(criteria);
using Request = std::array<EGLint, criterion_count>;

/// The bits that EGL and its extensions define.
constexpr EGLint api_bits =
    EGL_OPENGL_ES_BIT | EGL_OPENVG_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_BIT | EGL_OPENGL_ES3_BIT;
constexpr EGLint surface_bits = 0x1FFF;

/// Whether a value may be requested. Negative sizes may not.
bool is_value_of(const Criterion& criterion, EGLint value) {
    if (value == EGL_DONT_CARE) return criterion.name != EGL_LEVEL;
    switch (criterion.name) {
        case EGL_BIND_TO_TEXTURE_RGB:
        case EGL_BIND_TO_TEXTURE_RGBA:
        case EGL_NATIVE_RENDERABLE: return value == EGL_TRUE || value == EGL_FALSE;
        case EGL_COLOR_BUFFER_TYPE: return value == EGL_RGB_BUFFER || value == EGL_LUMINANCE_BUFFER;
        case EGL_CONFIG_CAVEAT:
            return value == EGL_NONE || value == EGL_SLOW_CONFIG ||
                   value == EGL_NON_CONFORMANT_CONFIG;
        case EGL_TRANSPARENT_TYPE: return value == EGL_NONE || value == EGL_TRANSPARENT_RGB;
        case EGL_CONFORMANT:
        case EGL_RENDERABLE_TYPE: return (value & ~api_bits) == 0;
        case EGL_SURFACE_TYPE: return (value & ~surface_bits) == 0;
    }
    return criterion.match != Match::AtLeast || value >= 0;
}

/// Whether a configuration has what is requested. OpenGL ES 1 is not asked for: it is the table's
/// initial value, and the screen savers request it for contexts of OpenGL.
bool fits(const Config& config, const Criterion& criterion, EGLint requested) {
    EGLint has = attribute(config, criterion.name).value_or(0);
    if (criterion.name == EGL_RENDERABLE_TYPE) has |= EGL_OPENGL_ES_BIT;
    return x11::fits(criterion.match, has, requested);
}

bool matches(const Config& config, const Request& request) {
    for (std::size_t i = 0; i < criterion_count; ++i)
        if (!fits(config, criteria[i], request[i])) return false;
    return true;
}

std::deque<Config> make_configs(const std::vector<XVisualInfo>& visuals) {
    std::deque<Config> configs;
    const auto add = [&](int samples, const XVisualInfo& visual) {
        configs.push_back({int(configs.size()) + 1, samples, visual});
    };
    for (const XVisualInfo& visual : visuals) add(0, visual);
    const int samples = offered_window_samples(settings().profile);
    std::set<int> depths;
    for (const XVisualInfo& visual : visuals)
        if (samples > 0 && depths.insert(visual.depth).second) add(samples, visual);
    return configs;
}

}  // namespace

std::deque<Config> make_x11_configs(Display* native, int screen) {
    return make_configs(x11::true_color_visuals(native, screen));
}

std::deque<Config> make_surfaceless_configs() { return make_configs({XVisualInfo{}}); }

std::optional<EGLint> attribute(const Config& c, EGLint name) {
    const Profile& profile = settings().profile;
    switch (name) {
        case EGL_BUFFER_SIZE: return 4 * profile.color_bits;
        case EGL_RED_SIZE:
        case EGL_GREEN_SIZE:
        case EGL_BLUE_SIZE:
        case EGL_ALPHA_SIZE: return profile.color_bits;
        case EGL_DEPTH_SIZE: return profile.depth_bits;
        case EGL_STENCIL_SIZE: return profile.stencil_bits;
        case EGL_LUMINANCE_SIZE:
        case EGL_ALPHA_MASK_SIZE:
        case EGL_LEVEL: return 0;
        case EGL_SAMPLE_BUFFERS: return c.samples > 0 ? 1 : 0;
        case EGL_SAMPLES: return c.samples;
        case EGL_BIND_TO_TEXTURE_RGB:
        case EGL_BIND_TO_TEXTURE_RGBA: return EGL_FALSE;
        case EGL_COLOR_BUFFER_TYPE: return EGL_RGB_BUFFER;
        case EGL_CONFIG_CAVEAT:
        case EGL_TRANSPARENT_TYPE: return EGL_NONE;
        case EGL_TRANSPARENT_RED_VALUE:
        case EGL_TRANSPARENT_GREEN_VALUE:
        case EGL_TRANSPARENT_BLUE_VALUE: return 0;
        case EGL_CONFIG_ID: return c.id;
        case EGL_RENDERABLE_TYPE:
        case EGL_CONFORMANT: return EGL_OPENGL_BIT;
        case EGL_SURFACE_TYPE:
            return c.has_windows() ? EGL_WINDOW_BIT | EGL_PIXMAP_BIT | EGL_PBUFFER_BIT
                                   : EGL_PBUFFER_BIT;
        case EGL_MAX_PBUFFER_WIDTH:
        case EGL_MAX_PBUFFER_HEIGHT: return max_window_size;
        case EGL_MAX_PBUFFER_PIXELS: return max_window_size * max_window_size;
        case EGL_MIN_SWAP_INTERVAL:
        case EGL_MAX_SWAP_INTERVAL: return 0;
        case EGL_NATIVE_RENDERABLE: return c.has_windows() ? EGL_TRUE : EGL_FALSE;
        case EGL_NATIVE_VISUAL_ID: return EGLint(c.visual.visualid);
        case EGL_NATIVE_VISUAL_TYPE: return c.has_windows() ? TrueColor : EGL_NONE;
    }
    return {};
}

std::vector<Config*> matching(std::deque<Config>& configs, const EGLint* list) {
    const std::optional<Request> request = x11::request_of(criteria, list, EGL_NONE, is_value_of);
    if (!request) throw Failure{EGL_BAD_ATTRIBUTE};
    std::vector<Config*> found;
    for (Config& config : configs)
        if (matches(config, *request)) found.push_back(&config);
    return found;
}

}  // namespace gw::gl::egl
