// Surfaces with samples: drawn to with all that a fragment meets, resolved to the window by blits.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <algorithm>
#include <utility>

namespace gw::conformance {
namespace {

MultisampleState any_multisample(Random& r) {
    MultisampleState m;
    m.enable = r.chance(85);
    m.alpha_to_coverage = r.chance(25);
    m.alpha_to_one = r.chance(20);
    m.coverage_test = r.chance(25);
    m.coverage = r.chance(80) ? float(r.real(0, 1)) : float(r.real(-2, 3));
    m.invert = r.chance(40);
    return m;
}

void any_fragments(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    state.multisample = any_multisample(r);
    state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
    state.depth = r.chance(70) ? any_depth(r) : DepthState{};
    state.stencil = r.chance(35) ? any_stencil(r, s.out.profile) : StencilState{};
    state.blend = r.chance(30) ? any_extended_blend(r) : BlendState{};
    state.logic_op.enable = s.out.profile.extensions.logic_op && r.chance(8);
    state.logic_op.op = r.any<LogicOp>();
    state.color_mask = r.chance(15) ? any_color_mask(r) : ColorMask{};
    state.fog = r.chance(25) ? any_fog(r, eye_depth(s.frame)) : FogState{};
    state.alpha = r.chance(25) ? any_alpha(r) : AlphaState{};
    state.draw_buffer = r.chance(95) ? DrawBuffer::Front : DrawBuffer::None;
    state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
    const Extensions& e = s.out.profile.extensions;
    state.polygon_offset.enable = e.polygon_offset && r.chance(25);
    state.polygon_offset.factor = float(r.real(-2, 2));
    state.polygon_offset.units = float(r.real(-50, 50));
}

void any_shapes(Script& s) {
    Random& r = s.random;
    State& state = s.state;
    const Extensions& e = s.out.profile.extensions;
    state.line_stipple = {};
    if (e.stipple && r.chance(30))
        state.line_stipple = {true, r.between(1, 4), std::uint16_t(r.bits(16))};
    state.polygon_mode = r.chance(75) ? PolygonMode::Fill : r.any(PolygonMode::Line);
    const bool smooth = s.out.profile.coverage_bits > 0;
    state.point_smooth = smooth && r.chance(25);
    state.line_smooth = smooth && r.chance(25);
    state.polygon_smooth = smooth && r.chance(25);
    state.point_size = float(r.between(1, 9));
    state.line_width = float(r.between(1, 5));
    state.point_sprite = e.point_sprite && r.chance(40);
    state.shade_model = r.any(ShadeModel::Smooth);
}

/// Fragments that nothing kills.
void plain_fragments(State& state) {
    state.multisample = {};
    state.depth = {};
    state.stencil = {};
    state.blend = {};
    state.alpha = {};
    state.logic_op.enable = false;
    state.color_mask = {};
    state.draw_buffer = DrawBuffer::Front;
}

void any_primitives(Script& s) {
    Random& r = s.random;
    any_fragments(s);
    any_shapes(s);
    if (s.state.point_sprite && r.chance(60)) plain_fragments(s.state);
    s.state.texture = any_texture_state(r);
    const MeshWish wish{.normals = true, .texcoords = r.chance(60), .most = 12};
    const MeshRef mesh = r.chance(s.state.point_sprite ? 20 : 80) ? any_mesh(r, s.frame, wish)
                                                                  : any_points(r, s.frame, wish);
    s.state.color_source = r.chance(75) ? ColorSource::Vertex : ColorSource::Lighting;
    if (s.state.color_source == ColorSource::Lighting) s.state.lighting = any_lighting(r);
    s.state.color_sum = s.out.profile.extensions.secondary_color && r.chance(15);
    Draw d = any_draw(s, mesh, s.state.point_sprite ? 90 : 50);
    s.state.texture.coord_replace = s.state.point_sprite && r.chance(70);
    add(s, std::move(d));
    s.state.texture.coord_replace = false;
}

/// With sides of equal length, flipped and beyond the borders.
Blit any_sample_blit(const Script& s, std::uint32_t from) {
    Random& r = s.random;
    Blit blit{.from_surface = from, .planes = PlaneMask(r.chance(70) ? 7 : r.below(8))};
    const int w = s.out.width, h = s.out.height;
    blit.source = {0, 0, w, h};
    if (r.chance(40))
        blit.source = {r.between(-3, w / 2), r.between(-3, h / 2), r.between(0, w + 4),
                       r.between(0, h + 4)};
    blit.target = {r.chance(60) ? 0 : r.between(-3, w / 2), 0, blit.source.width,
                   blit.source.height};
    blit.flip_x = r.chance(20);
    blit.flip_y = r.chance(20);
    blit.filter = r.any(MagFilter::Linear);
    return blit;
}

void any_command(Script& s, std::uint32_t used) {
    Random& r = s.random;
    const int kind = r.below(100);
    if (kind < 66) return any_primitives(s);
    any_fragments(s);
    if (kind < 76) return add(s, any_clear(r));
    if (kind < 82) return add(s, any_spans(r, s.out));
    if (kind < 90) return add(s, any_pixels(r, s.out));
    if (kind < 96) {
        DrawPixels pixels = any_draw_pixels(s);
        if (!pixels.source) add(s, std::move(pixels));
        return;
    }
    add(s, any_sample_blit(s, used));
}

void use(Script& s, std::uint32_t number) { s.out.list.add(UseSurface{number}); }

/// The means of all samples, then each plane's.
void show(Script& s, std::uint32_t number) {
    use(s, 0);
    s.state.scissor = {};
    s.state.draw_buffer = DrawBuffer::Front;
    const Rect all{0, 0, s.out.width, s.out.height};
    add(s, Blit{.from_surface = number, .planes = 7, .source = all, .target = all});
    between_draws(s);
}

}  // namespace

Case samples_case(Random& r) {
    Profile profile = any_opengl_profile(r, &Extensions::multisample);
    profile.subpixel_bits = std::max(profile.subpixel_bits, 3);
    Script s = script(r, profile);
    const int samples = r.pick({2, 4, 4, 8});
    PlaneMask planes = surface_planes;
    if (r.chance(15)) planes = PlaneMask(r.between(1, 7));
    for (const std::uint32_t number : {1u, 2u})
        s.out.list.add(MakeSurface{number, {s.out.width, s.out.height, planes, 0, samples}});
    const int rounds = r.between(1, 3);
    for (int i = 0; i < rounds; ++i) {
        const auto number = std::uint32_t(r.between(1, 2));
        use(s, number);
        const int commands = r.between(2, 9);
        for (int k = 0; k < commands; ++k) any_command(s, r.chance(50) ? number : 3 - number);
        show(s, number);
    }
    return s.out;
}

}  // namespace gw::conformance
