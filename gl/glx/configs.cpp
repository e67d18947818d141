#include "gl/glx/configs.h"

#include "gl/drawable/settings.h"
#include "gl/drawable/window_samples.h"
#include "gl/x11/criteria.h"
#include "gl/x11/geometry.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

namespace gw::gl::glx {

namespace {

using x11::Criterion;
using x11::Match;

/// [GLX 1.4] table 3.4
constexpr Criterion criteria[] = {
    {GLX_BUFFER_SIZE, Match::AtLeast, 0},
    {GLX_LEVEL, Match::Exact, 0},
    {GLX_DOUBLEBUFFER, Match::Exact},
    {GLX_STEREO, Match::Exact, False},
    {GLX_AUX_BUFFERS, Match::AtLeast, 0},
    {GLX_RED_SIZE, Match::AtLeast, 0},
    {GLX_GREEN_SIZE, Match::AtLeast, 0},
    {GLX_BLUE_SIZE, Match::AtLeast, 0},
    {GLX_ALPHA_SIZE, Match::AtLeast, 0},
    {GLX_DEPTH_SIZE, Match::AtLeast, 0},
    {GLX_STENCIL_SIZE, Match::AtLeast, 0},
    {GLX_ACCUM_RED_SIZE, Match::AtLeast, 0},
    {GLX_ACCUM_GREEN_SIZE, Match::AtLeast, 0},
    {GLX_ACCUM_BLUE_SIZE, Match::AtLeast, 0},
    {GLX_ACCUM_ALPHA_SIZE, Match::AtLeast, 0},
    {GLX_SAMPLE_BUFFERS, Match::AtLeast, 0},
    {GLX_SAMPLES, Match::AtLeast, 0},
    {GLX_RENDER_TYPE, Match::Mask, GLX_RGBA_BIT},
    {GLX_DRAWABLE_TYPE, Match::Mask, GLX_WINDOW_BIT},
    {GLX_X_RENDERABLE, Match::Exact},
    {GLX_X_VISUAL_TYPE, Match::Exact},
    {GLX_CONFIG_CAVEAT, Match::Exact},
    {GLX_SWAP_METHOD_OML, Match::Exact},
    {GLX_TRANSPARENT_TYPE, Match::Exact, GLX_NONE},
    {GLX_TRANSPARENT_INDEX_VALUE, Match::Ignored},
    {GLX_TRANSPARENT_RED_VALUE, Match::Ignored},
    {GLX_TRANSPARENT_GREEN_VALUE, Match::Ignored},
    {GLX_TRANSPARENT_BLUE_VALUE, Match::Ignored},
    {GLX_TRANSPARENT_ALPHA_VALUE, Match::Ignored},
    {GLX_MAX_PBUFFER_WIDTH, Match::Ignored},
    {GLX_MAX_PBUFFER_HEIGHT, Match::Ignored},
    {GLX_MAX_PBUFFER_PIXELS, Match::Ignored},
    {GLX_VISUAL_ID, Match::Ignored},
    {GLX_SCREEN, Match::Ignored},
    {GLX_FBCONFIG_ID, Match::Exact},
};

bool is_boolean(int name) {
    return name == GLX_DOUBLEBUFFER || name == GLX_STEREO || name == GLX_X_RENDERABLE;
}

/// Whether a value may be requested. Negative sizes may not.
bool is_value_of(const Criterion& criterion, int value) {
    if (value == int(GLX_DONT_CARE)) return criterion.name != GLX_LEVEL;
    if (criterion.match == Match::AtLeast) return value >= 0;
    return !is_boolean(criterion.name) || value == True || value == False;
}

constexpr std::size_t criterion_count = std::size(criteria);
using Request = std::array<int, criterion_count>;

bool matches(const Config& config, const Request& request) {
    for (std::size_t i = 0; i < criterion_count; ++i)
        if (!x11::fits(criteria[i].match, *attribute(config, criteria[i].name), request[i]))
            return false;
    return true;
}

/// What configurations differ in beside their visual.
struct Kind {
    bool double_buffered;
    int samples;
};

/// In the order in which the visuals of a depth are dealt out to them.
std::vector<Kind> kinds_of(const Profile& profile) {
    std::vector<Kind> kinds{{true, 0}, {false, 0}};
    if (const int samples = offered_window_samples(profile); samples > 0)
        kinds.insert(kinds.end(), {{true, samples}, {false, samples}});
    return kinds;
}

/// The visuals of each depth. Visuals and depths keep their order.
std::vector<std::vector<XVisualInfo>> by_depth(const std::vector<XVisualInfo>& visuals) {
    std::vector<std::vector<XVisualInfo>> out;
    for (const XVisualInfo& visual : visuals) {
        const auto same = std::find_if(out.begin(), out.end(), [&](const auto& of) {
            return of.front().depth == visual.depth;
        });
        if (same == out.end())
            out.push_back({visual});
        else
            same->push_back(visual);
    }
    return out;
}

}  // namespace

std::deque<Config> make_configs(Display* display, int screen, int first_id) {
    const Profile& profile = settings().profile;
    const std::vector<Kind> kinds = kinds_of(profile);
    std::deque<Config> configs;
    for (const auto& visuals : by_depth(x11::true_color_visuals(display, screen)))
        for (std::size_t i = 0; i < std::max(visuals.size(), kinds.size()); ++i) {
            const auto [double_buffered, samples] = kinds[i < kinds.size() ? i : 0];
            configs.push_back({visuals[i % visuals.size()], double_buffered, samples, 0,
                               profile.color_bits, profile.depth_bits, profile.stencil_bits,
                               profile.accum_bits});
        }
    std::stable_sort(configs.begin(), configs.end(), [](const Config& a, const Config& b) {
        return std::tuple(a.double_buffered, a.samples) < std::tuple(b.double_buffered, b.samples);
    });
    for (Config& config : configs) config.id = first_id++;
    return configs;
}

std::optional<int> attribute(const Config& c, int name) {
    switch (name) {
        case GLX_BUFFER_SIZE: return 4 * c.color_bits;
        case GLX_LEVEL:
        case GLX_STEREO:
        case GLX_AUX_BUFFERS: return 0;
        case GLX_SAMPLE_BUFFERS: return c.samples > 0 ? 1 : 0;
        case GLX_SAMPLES: return c.samples;
        case GLX_DOUBLEBUFFER: return c.double_buffered ? True : False;
        case GLX_RED_SIZE:
        case GLX_GREEN_SIZE:
        case GLX_BLUE_SIZE:
        case GLX_ALPHA_SIZE: return c.color_bits;
        case GLX_DEPTH_SIZE: return c.depth_bits;
        case GLX_STENCIL_SIZE: return c.stencil_bits;
        case GLX_ACCUM_RED_SIZE:
        case GLX_ACCUM_GREEN_SIZE:
        case GLX_ACCUM_BLUE_SIZE:
        case GLX_ACCUM_ALPHA_SIZE: return c.accum_bits;
        case GLX_RENDER_TYPE: return GLX_RGBA_BIT;
        case GLX_SWAP_METHOD_OML:
            if (!c.double_buffered) return GLX_SWAP_UNDEFINED_OML;
            return settings().swap == SwapMethod::Copy ? GLX_SWAP_COPY_OML : GLX_SWAP_EXCHANGE_OML;
        case GLX_RGBA: return True;  // freeglut asks configurations for it
        case GLX_DRAWABLE_TYPE: return GLX_WINDOW_BIT | GLX_PIXMAP_BIT | GLX_PBUFFER_BIT;
        case GLX_X_RENDERABLE: return True;
        case GLX_X_VISUAL_TYPE: return GLX_TRUE_COLOR;
        case GLX_CONFIG_CAVEAT:
        case GLX_TRANSPARENT_TYPE: return GLX_NONE;
        case GLX_TRANSPARENT_INDEX_VALUE:
        case GLX_TRANSPARENT_RED_VALUE:
        case GLX_TRANSPARENT_GREEN_VALUE:
        case GLX_TRANSPARENT_BLUE_VALUE:
        case GLX_TRANSPARENT_ALPHA_VALUE: return 0;
        case GLX_MAX_PBUFFER_WIDTH:
        case GLX_MAX_PBUFFER_HEIGHT: return max_window_size;
        case GLX_MAX_PBUFFER_PIXELS: return max_window_size * max_window_size;
        case GLX_VISUAL_ID: return int(c.visual.visualid);
        case GLX_SCREEN: return c.visual.screen;
        case GLX_FBCONFIG_ID: return c.id;
    }
    return {};
}

std::optional<std::vector<Config*>> matching(std::deque<Config>& configs, const int* list) {
    const std::optional<Request> request = x11::request_of(criteria, list, 0, is_value_of);
    if (!request) return {};
    std::vector<Config*> found;
    for (Config& config : configs)
        if (matches(config, *request)) found.push_back(&config);
    return found;
}

std::optional<std::vector<int>> list_of_visual_attributes(const int* list) {
    bool rgba = false, double_buffered = false, stereo = false;
    std::vector<int> out;
    while (list != nullptr && *list != 0) {
        const int name = *list++;
        if (name == GLX_USE_GL) continue;
        if (name == GLX_RGBA || name == GLX_DOUBLEBUFFER || name == GLX_STEREO) {
            (name == GLX_RGBA ? rgba : name == GLX_STEREO ? stereo : double_buffered) = true;
            continue;
        }
        const int value = *list++;
        // [GLX 1.4] 3.3.10: GLX_BUFFER_SIZE counts for colour indices only.
        if (name != GLX_BUFFER_SIZE) out.insert(out.end(), {name, value});
    }
    if (!rgba) return {};
    out.insert(out.end(), {GLX_DOUBLEBUFFER, double_buffered, GLX_STEREO, stereo, 0});
    return out;
}

}  // namespace gw::gl::glx
