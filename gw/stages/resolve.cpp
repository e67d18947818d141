#include "gw/stages/resolve.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "gw/stages/fog.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gw {

Rect intersect(const Rect& a, const Rect& b) {
    // In 64 bits, because the sides of a given rectangle may exceed int.
    const std::int64_t x0 = std::max(a.x, b.x), y0 = std::max(a.y, b.y);
    const std::int64_t x1 = std::min(std::int64_t{a.x} + a.width, std::int64_t{b.x} + b.width);
    const std::int64_t y1 = std::min(std::int64_t{a.y} + a.height, std::int64_t{b.y} + b.height);
    if (x1 <= x0 || y1 <= y0) return {};
    return {int(x0), int(y0), int(x1 - x0), int(y1 - y0)};
}

Rgba quantize_color(const vec4& color, int bits) {
    Rgba out;
    for (int i = 0; i < 4; ++i)
        out[std::size_t(i)] = static_cast<std::uint16_t>(quantize(color[i], bits));
    return out;
}

namespace {

StencilFace stencil_face(const StencilFace& face, bool test, std::uint32_t max) {
    if (!test) return {.write_mask = 0};
    StencilFace out = face;
    out.mask &= max;
    out.write_mask &= max;
    return out;
}

/// Limited to normal numbers.
float two_to_the(float v) {
    constexpr double ln2 = 0x1.62e42fefa39efp-1;
    return v == 0 ? 1.0f : static_cast<float>(exp(bounded(double(v), 126) * ln2));
}

ResolvedTexture resolve_texture(const TextureState& s, const Profile& profile) {
    return {.env_color = quantize_color(s.env_color, profile.color_bits),
            .border_color = quantize_color(s.border_color, profile.color_bits),
            .rho_scale = two_to_the(s.lod.bias),
            .least_rho = two_to_the(s.lod.min),
            .greatest_rho = two_to_the(s.lod.max)};
}

ViewportTransform viewport_transform(const Rect& v, const ClipControlState& control) {
    const double half_height = v.height / 2.0;
    return {v.width / 2.0, control.origin == ClipOrigin::UpperLeft ? -half_height : half_height,
            v.x + v.width / 2.0, v.y + half_height, control.depth == ClipDepth::ZeroToOne};
}

}  // namespace

const TextureState& texture_of(const State& state, std::size_t unit) {
    static const TextureState initial;
    if (unit == 0) return state.texture;
    return state.more_textures.units ? (*state.more_textures.units)[unit - 1] : initial;
}

namespace {

/// Without samples there are none to lose; with samples of their own places, edges are smooth.
void resolve_samples(State& s, int samples) {
    if (samples == 1 || !s.multisample.enable)
        s.multisample = {.enable = false};
    else
        s.point_smooth = s.line_smooth = s.polygon_smooth = s.diamond_lines = false;
}

void resolve_masks(Resolved& r) {
    const ColorMask& m = r.state.color_mask;
    const ColorMaskBits& b = r.state.color_mask_bits;
    const auto all = std::uint16_t(max_of_bits(r.bits));
    if (r.state.draw_buffer != DrawBuffer::None)
        r.written_bits = {std::uint16_t(m.r ? b.r & all : 0), std::uint16_t(m.g ? b.g & all : 0),
                          std::uint16_t(m.b ? b.b & all : 0), std::uint16_t(m.a ? b.a & all : 0)};
    r.writes_color = r.written_bits != Rgba{};
    r.writes_whole_color = r.written_bits == Rgba{all, all, all, all};
    r.writes_part_bits = std::any_of(r.written_bits.begin(), r.written_bits.end(),
                                     [&](std::uint16_t bits) { return bits != 0 && bits != all; });
}

Resolved resolve(const State& state, const Profile& profile, int width, int height, int samples) {
    Resolved r;
    r.state = state;
    r.samples = samples;
    resolve_samples(r.state, samples);
    r.bits = profile.color_bits;
    r.stencil_max = max_of_bits(profile.stencil_bits);

    const Rect window{0, 0, width, height};
    const ViewportState& v = state.viewport;
    const Rect viewport =
        v.width == 0 && v.height == 0 ? window : Rect{v.x, v.y, v.width, v.height};
    r.pixel_box = state.scissor.test ? intersect(window, state.scissor.box) : window;
    r.draw_box = intersect(viewport, r.pixel_box);
    r.viewport = viewport_transform(viewport, state.clip_control);
    if (state.clip_control.origin == ClipOrigin::UpperLeft)
        r.state.cull.front = state.cull.front == Winding::CW ? Winding::CCW : Winding::CW;

    r.depth_mask = state.depth.mask;
    if (!state.depth.test) r.state.depth = {.func = DepthFunc::Always, .mask = false};
    if (!state.alpha.test) r.state.alpha.func = AlphaFunc::Always;
    r.alpha_ref = quantize(state.alpha.ref, r.bits);

    const StencilState& s = state.stencil;
    r.front = stencil_face(s.front(), s.test, r.stencil_max);
    r.back = s.two_side ? stencil_face(s.back, s.test, r.stencil_max) : r.front;

    r.fog_color = quantize_color(state.fog.color, r.bits);
    r.blend_color = quantize_color(state.blend.color, r.bits);
    static_cast<ResolvedTexture&>(r) = resolve_texture(state.texture, profile);
    if (state.more_textures.units)
        for (std::size_t i = 0; i < r.more_textures.size(); ++i)
            r.more_textures[i] = resolve_texture((*state.more_textures.units)[i], profile);
    if (state.logic_op.enable) r.state.blend.enable = false;
    r.fragment_fog = fog_is_per_fragment(state.fog, profile);
    resolve_masks(r);
    return r;
}

}  // namespace

Resolved resolve(const State& state, const Profile& profile, int width, int height) {
    return resolve(state, profile, width, height, 1);
}

Resolved resolve(const State& state, const Profile& profile, const Surface& surface) {
    if (surface.is_window()) return resolve(state, profile, surface.width, surface.height);
    State s = state;
    s.read_buffer = ReadBuffer::Front;
    if (s.draw_buffer != DrawBuffer::None) s.draw_buffer = DrawBuffer::Front;
    if (!surface.has(Plane::Color)) s.draw_buffer = DrawBuffer::None;
    if (!surface.has(Plane::Depth)) s.depth = {.mask = false};
    if (!surface.has(Plane::Stencil)) s.stencil = {.write_mask = 0};
    return resolve(s, profile, surface.width, surface.height, surface.sample_count());
}

std::uint64_t plane_bytes(Plane plane, const Profile& profile) {
    const auto whole = [](int bits) { return static_cast<std::uint64_t>((bits + 7) / 8); };
    switch (plane) {
        case Plane::Color:
        case Plane::Back: return 4 * whole(profile.color_bits);
        case Plane::Depth: return whole(profile.depth_bits);
        case Plane::Stencil: return 1;
        case Plane::Accum: return 4 * whole(profile.accum_bits);
    }
    return 0;
}

std::uint64_t written_bytes(Plane plane, const State& state, const Profile& profile) {
    const bool both = plane == Plane::Color && draws_to_both(state);
    return (both ? 2 : 1) * plane_bytes(plane, profile);
}

FragmentBytes fragment_bytes(const Resolved& r, const Profile& profile) {
    const auto bytes = [&](Plane plane) { return plane_bytes(plane, profile); };
    const bool reads_color =
        r.writes_color &&
        (r.state.blend.enable || reads_stored(r.state.logic_op) || !r.writes_whole_color);
    FragmentBytes b;
    if (r.state.stencil.test)
        b.after_alpha =
            bytes(Plane::Stencil) * (keeps_stencil(r.front) && keeps_stencil(r.back) ? 1 : 2);
    if (r.state.depth.func != DepthFunc::Always) b.after_stencil = bytes(Plane::Depth);
    if (r.state.depth.mask) b.written += bytes(Plane::Depth);
    if (r.writes_color)
        b.written += written_bytes(Plane::Color, r.state, profile) * (reads_color ? 2 : 1);
    return b;
}

}  // namespace gw
