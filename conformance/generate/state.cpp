#include "conformance/generate/state.h"

#include <cmath>
#include <utility>

namespace gw::conformance {
namespace {

StencilOp any_stencil_op(Random& r, const Profile& p) {
    return r.chance(25)
               ? StencilOp::Keep
               : r.any(p.extensions.stencil_wrap ? StencilOp::DecrWrap : StencilOp::Invert);
}

StencilFace any_stencil_face(Random& r, const Profile& p) {
    StencilFace f;
    f.func = r.chance(30) ? StencilFunc::Always : r.any<StencilFunc>();
    f.ref = r.chance(70) ? r.below(4) : r.chance(80) ? r.below(256) : r.pick({-1, 256, 1 << 30});
    if (r.chance(40)) f.mask = r.chance(50) ? r.bits(3) : r.bits(8);
    if (r.chance(40)) f.write_mask = r.chance(50) ? r.bits(3) : r.bits(8);
    f.fail = any_stencil_op(r, p);
    f.zfail = any_stencil_op(r, p);
    f.zpass = any_stencil_op(r, p);
    return f;
}

}  // namespace

float any_fraction(Random& r) {
    const int kind = r.below(10);
    if (kind < 2) return r.pick({0.0f, 1.0f, 0.5f});
    if (kind < 4) return float(r.below(256)) / 255;
    if (kind < 9) return float(r.real(0, 1));
    return float(r.real(-1, 2));
}

vec4 any_color(Random& r) {
    return {any_fraction(r), any_fraction(r), any_fraction(r), any_fraction(r)};
}

AlphaState any_alpha(Random& r) {
    return {r.chance(70), r.any<AlphaFunc>(), r.chance(50) ? any_fraction(r) : 0.5f};
}

BlendState any_blend(Random& r) {
    using enum BlendFactor;
    if (r.chance(25)) return {true, One, One};
    const bool enable = r.chance(90);
    const BlendFactor src =
        r.pick({Zero, One, DstColor, OneMinusDstColor, SrcAlpha, OneMinusSrcAlpha, DstAlpha,
                OneMinusDstAlpha, SrcAlphaSaturate});
    const BlendFactor dst = r.pick({Zero, One, SrcColor, OneMinusSrcColor, SrcAlpha,
                                    OneMinusSrcAlpha, DstAlpha, OneMinusDstAlpha});
    return {enable, src, dst};
}

BlendState any_extended_blend(Random& r) {
    using enum BlendFactor;
    BlendState b = any_blend(r);
    b.equation = r.any<BlendEquation>();
    b.color = any_color(r);
    const auto constant = [&] {
        return r.pick({ConstantColor, OneMinusConstantColor, ConstantAlpha, OneMinusConstantAlpha});
    };
    if (r.chance(40)) b.src = constant();
    if (r.chance(40)) b.dst = constant();
    return b;
}

BlendState any_separate_blend(Random& r) {
    using enum BlendFactor;
    const auto factors = [&r](BlendFactor& src, BlendFactor& dst) {
        src = r.chance(40) ? r.pick({SrcColor, OneMinusSrcColor}) : r.any<BlendFactor>();
        dst = r.chance(40) ? r.pick({DstColor, OneMinusDstColor}) : r.any<BlendFactor>();
        if (dst == SrcAlphaSaturate) dst = Zero;
    };
    BlendState b = any_extended_blend(r);
    if (r.chance(70)) factors(b.src, b.dst);
    if (r.chance(40)) b.equation = BlendEquation::Add;
    b.alpha.separate = r.chance(75);
    b.alpha.equation = r.any<BlendEquation>();
    factors(b.alpha.src, b.alpha.dst);
    return b;
}

LogicOpState any_logic_op(Random& r) { return {r.chance(85), r.any<LogicOp>()}; }

ColorMask any_color_mask(Random& r) {
    if (r.chance(60)) return {};
    return {r.chance(60), r.chance(60), r.chance(60), r.chance(60)};
}

CullState any_cull(Random& r) {
    return {r.chance(60), r.chance(10) ? Face::FrontAndBack : r.pick({Face::Front, Face::Back}),
            r.any<Winding>()};
}

DepthState any_depth(Random& r) {
    const DepthFunc func =
        r.chance(50)
            ? r.pick({DepthFunc::Less, DepthFunc::LEqual, DepthFunc::Greater, DepthFunc::Equal})
            : r.any<DepthFunc>();
    return {r.chance(90), func, r.chance(75)};
}

DepthRangeState any_depth_range(Random& r) {
    if (r.chance(50)) return {};
    const auto end = [&r] { return r.chance(50) ? r.below(5) / 4.0 : r.real(-0.25, 1.25); };
    return {end(), end()};
}

JitterState any_jitter(Random& r, const Profile& p) {
    const int most = (1 << p.subpixel_bits) - 1;
    return {r.between(-most, most), r.between(-most, most)};
}

LineStippleState any_dashes(Random& r) {
    return {true, r.chance(70) ? r.between(1, 4) : r.between(1, 256), std::uint16_t(r.bits(16))};
}

PolygonOffsetState any_polygon_offset(Random& r, const Profile& p) {
    if (!p.extensions.polygon_offset) return {};
    const auto amount = [&r] {
        const int kind = r.below(10);
        if (kind < 6) return float(r.between(-4, 4));
        if (kind < 9) return float(r.scaled(-1, 1, 0, 24));
        return r.pick({0.5f, -0.5f, 1.5f, 1e30f, -1e30f});
    };
    return {r.chance(80), amount(), amount()};
}

ScissorState any_scissor(Random& r, int width, int height) {
    ScissorState s{r.chance(80)};
    s.box = {r.between(-3, width), r.between(-3, height), r.between(0, width + 3),
             r.between(0, height + 3)};
    if (r.chance(5)) s.box = {-2147483647 - 1, -5, 2147483647, 2147483647};
    if (r.chance(5)) s.box = {-3, -3, 2147483647, 2147483647};
    return s;
}

StencilState any_stencil(Random& r, const Profile& p) {
    StencilState s;
    s.test = r.chance(90);
    const StencilFace f = any_stencil_face(r, p);
    s.func = f.func;
    s.ref = f.ref;
    s.mask = f.mask;
    s.fail = f.fail;
    s.zfail = f.zfail;
    s.zpass = f.zpass;
    s.write_mask = f.write_mask;
    s.back = any_stencil_face(r, p);
    s.two_side = p.extensions.two_sided_stencil && r.chance(60);
    return s;
}

ViewportState any_viewport(Random& r, int width, int height) {
    if (r.chance(30)) return {};
    if (r.chance(10))
        return {r.between(-4096, 4096), r.between(-4096, 4096), r.between(1, 4096),
                r.between(1, 4096)};
    return {r.between(-width, width), r.between(-height, height), r.between(1, 2 * width),
            r.between(1, 2 * height)};
}

void any_clip_planes(Random& r, const Frame& f, State& state) {
    for (ClipPlane& plane : state.clip_planes) {
        plane.enable = r.chance(35);
        // Through a point of the picture at the eye distance z, in any direction.
        const double z = f.deep ? f.near_z * r.real(1, 4) : r.real(-1, 1), w = f.deep ? z : 1;
        const dvec3 through{w * r.real(0, f.width), w * r.real(0, f.height), -z};
        const dvec3 normal{double(r.between(-4, 4)), double(r.between(-4, 4)),
                           double(r.between(-2, 2))};
        const double scale = r.chance(10) ? std::ldexp(1.0, r.between(-200, 200)) : 1;
        plane.plane = dvec4(normal, -dot3(normal, through)) * scale;
    }
}

FogState any_fog(Random& r, double depth) {
    FogState f;
    f.enable = r.chance(92);
    f.mode = r.any<FogMode>();
    f.start = float(r.real(-0.5, 0.8) * depth);
    f.end = f.start + float(r.real(0.05, 1.2) * depth);
    if (r.chance(10)) std::swap(f.start, f.end);
    f.density = float(r.real(0.1, 4) / depth);
    if (r.chance(5)) f.density *= r.pick({1e-30f, 1e6f, 1e-3f});
    if (f.end == f.start || !std::isfinite(f.end)) f.end = f.start + 1;
    if (f.end == f.start) {
        f.start = 0;
        f.end = 1;
    }
    if (!(f.density > 0) || !std::isfinite(f.density)) f.density = 1;
    f.color = any_color(r);
    f.coordinate = r.any<FogCoordinate>();
    return f;
}

LightingState any_lighting(Random& r) {
    return {r.chance(50), r.chance(40), r.chance(50) ? vec4(0, 0, 0, 1) : any_color(r)};
}

TextureState any_texture_state(Random& r) {
    TextureState t;
    t.min_filter = r.any<MinFilter>();
    t.mag_filter = r.any<MagFilter>();
    t.wrap_s = r.any(Wrap::Clamp);
    t.wrap_t = r.any(Wrap::Clamp);
    t.env = r.any(TexEnv::Replace);
    t.env_color = any_color(r);
    return t;
}

void any_combine(Random& r, TextureState& t) {
    const auto any = [&r](CombineState& s, CombineFunc last) {
        s.func = r.any(last);
        for (CombineSource* source : {&s.source0, &s.source1, &s.source2})
            *source = r.any(CombineSource::Previous);
        for (CombineOperand* operand : {&s.operand0, &s.operand1, &s.operand2})
            *operand = r.any<CombineOperand>();
        s.scale = r.pick({1, 1, 2, 4});
    };
    any(t.combine_rgb, CombineFunc::Dot3Rgba);
    any(t.combine_alpha, CombineFunc::Subtract);
}

TextureState any_later_texture_state(Random& r) {
    TextureState t = any_texture_state(r);
    const auto wrap = [&r] {
        return r.chance(50) ? r.pick({Wrap::ClampToBorder, Wrap::MirroredRepeat}) : r.any<Wrap>();
    };
    t.wrap_s = wrap();
    t.wrap_t = wrap();
    t.border_color = any_color(r);
    if (r.chance(40)) return t;
    t.min_filter = r.any<MinFilter>();
    const auto level = [&r] { return r.chance(80) ? r.between(0, 3) : r.between(0, 1000); };
    const auto amount = [&r] {
        return r.chance(90) ? float(r.between(-16, 16)) / 4 : float(r.scaled(-1, 1, 0, 100));
    };
    if (r.chance(50)) t.lod.base_level = level();
    if (r.chance(50)) t.lod.max_level = level();
    if (r.chance(60)) t.lod.bias = amount();
    if (r.chance(40)) t.lod.min = amount();
    if (r.chance(40)) t.lod.max = amount();
    return t;
}

}  // namespace gw::conformance
