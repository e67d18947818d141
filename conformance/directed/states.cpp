// States that resolve to others, or have no effect: a viewport without a size, no draw buffer,
// identifiers as colours of drawn pixels.
#include "conformance/cases.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

namespace {

/// [R4.3] The corner of a viewport without a size has no effect. [R4.5] The reference is rounded to
/// 128; alphas around it. [R4.5] Stencil references beyond the plane.
void draw_resolved(Script& s, int side) {
    Random& r = s.random;
    s.state.viewport = {r.between(3, 8), -r.between(3, 8), 0, 0};
    MeshData data = rectangle(1, 1, float(side), float(side));
    for (int i = 0; i < 4; ++i)
        data.colors.push_back({float(r.real(0, 1)), 0.5f, 0.75f, i % 3 == 0 ? 0.485f : 0.515f});
    const MeshRef mesh = make_mesh(data);
    add(s, Draw{.mesh = mesh});
    s.state.viewport = {};
    for (const AlphaFunc func : {AlphaFunc::Greater, AlphaFunc::LEqual}) {
        s.state.alpha = {true, func, 0.5f};
        add(s, Clear{mask_of(Plane::Color)});
        add(s, Draw{.mesh = mesh});
    }
    s.state.alpha = {};
    // [R6.20] The depth range is clamped first.
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    s.state.depth_range = {-r.real(0.25, 1), 1 + r.real(0.25, 1)};
    MeshData slope = rectangle(0, 0, float(side), float(side));
    for (vec3& p : slope.positions) p.z = float(r.real(-1, 1));
    add(s, Draw{.mesh = make_mesh(slope)});
    s.state.depth_range = {};
    s.state.depth = {};
    s.state.stencil = {.test = true, .func = StencilFunc::LEqual, .ref = 256 + r.between(1, 9)};
    s.state.stencil.zpass = s.state.stencil.fail = StencilOp::Replace;
    add(s, Draw{.mesh = mesh});
    s.state.stencil = {};
}

}  // namespace

// [R14.8] Under every draw buffer, the commands that write colours.
Case state_rules_case(Random& r) {
    constexpr int side = 12;
    Script s = pixel_script(r, opengl_up_to(&Extensions::draw_pixels), side, side);
    draw_resolved(s, side);
    for (const DrawBuffer buffer : {DrawBuffer::FrontAndBack, DrawBuffer::None, DrawBuffer::Back}) {
        s.state.draw_buffer = buffer;
        s.state.read_buffer = r.any(ReadBuffer::Back);
        s.state.color_mask = r.chance(50) ? any_color_mask(r) : ColorMask{};
        add(s, Clear{all_planes, any_color(r), 1, 0, any_color(r)});
        add(s, Accumulate{AccumOp::Accum, 0.5f});
        add(s, Copy{.source = {0, 0, 5, 7}, .x = 4, .y = 3});
        add(s, Accumulate{AccumOp::Return, 0.75f});
    }
    s.state.draw_buffer = DrawBuffer::Front;
    s.state.color_mask = {};
    // [R13.12] color_source has no effect on drawn pixels.
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 16; ++i) texels.push_back(std::uint16_t(r.bits(16)));
    const TextureRef texture = make_texture("noise", 4, 4, texels);
    for (const ColorSource source : {ColorSource::PolygonId, ColorSource::Lighting}) {
        s.state.color_source = source;
        s.state.texture = any_texture_state(r);
        DrawPixels d{.width = side, .height = side, .map = {texture, {}}};
        d.raster.texcoord = {float(r.real(0, 1)), float(r.real(0, 1)), 0, 1};
        for (int i = 0; i < side * side; ++i) d.colors.push_back(any_pixel(r, 8));
        add(s, std::move(d));
    }
    return s.out;
}

}  // namespace gw::conformance
