// Shading a block of 16 pixels of one primitive: planes, colour, texture, fog. docs/manual.md, "Planes" to
// "Fog"; scalar twins: gw/reference/interpolants.cpp, texture_unit.cpp, shade.cpp. Does not decide coverage
// or test. Included once per Highway target.
#if defined(GW_FAST_SHADE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SHADE_INL_H_
#undef GW_FAST_SHADE_INL_H_
#else
#define GW_FAST_SHADE_INL_H_
#endif

#include "gw/fast/fragments-inl.h"
#include "gw/fast/primitive.h"
#include "gw/fog.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

alignas(64) inline constexpr std::uint32_t lane_x[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr std::uint32_t lane_y[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Pixel coordinates in the tile of lanes first .. of block (bx, by).
struct Pixels {
    V32 x, y;
};
HWY_INLINE Pixels pixels_of(int bx, int by, std::size_t first) {
    const D32 d;
    return {hn::Add(hn::Load(d, lane_x + first), hn::Set(d, std::uint32_t(bx * block_side))),
            hn::Add(hn::Load(d, lane_y + first), hn::Set(d, std::uint32_t(by * block_side)))};
}

/// A value of at most 16 bits: one chain modulo 2^32.
HWY_INLINE V32 narrow_plane(const TilePlane& p, Pixels at) {
    const D32 d;
    const auto x = hn::Mul(hn::Set(d, std::uint32_t(p.gx)), at.x),
               y = hn::Mul(hn::Set(d, std::uint32_t(p.gy)), at.y);
    return hn::ShiftRight<16>(hn::Add(hn::Add(hn::Set(d, std::uint32_t(p.c)), x), y));
}

/// A value of up to 32 bits: high and low halves apart, exact modulo 2^32.
HWY_INLINE V32 wide_plane(const TilePlane& p, Pixels at) {
    const auto high = [](std::int64_t v) { return hn::Set(D32(), std::uint32_t(v >> 16)); };
    const auto low = [](std::int64_t v) { return hn::Set(D32(), std::uint32_t(v & 0xFFFF)); };
    const auto hi =
        hn::Add(hn::Add(high(std::int64_t(p.c)), hn::Mul(high(p.gx), at.x)), hn::Mul(high(p.gy), at.y));
    const auto lo =
        hn::Add(hn::Add(low(std::int64_t(p.c)), hn::Mul(low(p.gx), at.x)), hn::Mul(low(p.gy), at.y));
    return hn::Add(hi, hn::ShiftRight<16>(lo));
}

HWY_INLINE hn::Vec<F32> to_floats(V32 v) { return hn::ConvertTo(F32(), hn::BitCast(I32(), v)); }

HWY_INLINE hn::Vec<F32> reciprocal_lanes(const TilePlane& q, Pixels at) {
    return hn::Div(hn::Set(F32(), 1.0f), to_floats(wide_plane(q, at)));
}

HWY_INLINE void store16(V32 v, std::uint16_t* p) { hn::Store(narrow(v), Half16(), p); }

HWY_INLINE void shade_depth(const PrimitivePlanes& p, std::uint32_t max_depth, int bx, int by,
                            DepthBlock& out) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        hn::Store(wide_plane(p.depth, pixels_of(bx, by, i)), d, out.value + i);
    if (p.depth_offset != 0)
        for (std::uint32_t& z : out.value)
            z = std::uint32_t(std::clamp<std::int64_t>(z + p.depth_offset, 0, max_depth));
}

HWY_INLINE void interpolated_color(const PrimitivePlanes& p, int bits, int bx, int by, ColorBlock& out) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        if (!p.perspective_color) {
            for (std::size_t c = 0; c < 4; ++c) store16(narrow_plane(p.color[c], at), out.channel[c] + i);
            continue;
        }
        const auto w = reciprocal_lanes(p.q, at);
        const auto scale = hn::Set(F32(), float(max_of_bits(bits)));
        for (std::size_t c = 0; c < 4; ++c) {
            const auto f = hn::Mul(hn::Mul(to_floats(wide_plane(p.color[c], at)), w), scale);
            const auto v = hn::BitCast(d, hn::NearestInt(f));
            const auto low = hn::Set(d, p.color_low[c]), high = hn::Set(d, p.color_high[c]);
            // Lanes that the primitive does not cover may hold anything; 16 bits must still fit.
            store16(hn::Min(hn::Max(v, low), high), out.channel[c] + i);
        }
    }
}

// --- Texture
// ----------------------------------------------------------------------------------------------------------

/// U W 2^e in 1/256 texels, as integers; at most 2^30.
HWY_INLINE hn::Vec<I32> texel_coordinate(const TexturePlane& t, hn::Vec<F32> w, Pixels at) {
    const auto limit = hn::Set(F32(), 1073741824.0f);
    const auto scaled = hn::Mul(hn::Mul(to_floats(wide_plane(t.plane, at)), w), hn::Set(F32(), t.scale));
    const auto u = hn::ConvertTo(I32(), hn::Max(hn::Zero(F32()), hn::Min(scaled, limit)));
    return hn::Add(u, hn::Set(I32(), t.offset));
}

HWY_INLINE hn::Vec<I32> wrap_lanes(Wrap wrap, hn::Vec<I32> i, int size) {
    const auto last = hn::Set(I32(), size - 1);
    return wrap == Wrap::Repeat ? hn::And(i, last) : hn::Min(hn::Max(i, hn::Zero(I32())), last);
}

/// Four channels of one texel per lane.
struct TexelLanes {
    V32 channel[4];
};

HWY_INLINE TexelLanes fetch(const FastTexels& t, hn::Vec<I32> index) {
    const D32 d;
    TexelLanes out;
    if (!t.packed.empty()) {
        const auto v = hn::GatherIndex(d, t.packed.data(), index);
        const auto byte = hn::Set(d, 255u);
        out.channel[0] = hn::And(v, byte);
        out.channel[1] = hn::And(hn::ShiftRight<8>(v), byte);
        out.channel[2] = hn::And(hn::ShiftRight<16>(v), byte);
        out.channel[3] = hn::ShiftRight<24>(v);
        return out;
    }
    const auto* base = reinterpret_cast<const std::uint32_t*>(t.texels.levels[0].texels.data());
    const auto two = hn::Add(index, index), low = hn::Set(I32(), 0xFFFF);
    const auto rg = hn::GatherIndex(d, base, two),
               ba = hn::GatherIndex(d, base, hn::Add(two, hn::Set(I32(), 1)));
    out.channel[0] = hn::And(rg, hn::BitCast(d, low));
    out.channel[1] = hn::ShiftRight<16>(rg);
    out.channel[2] = hn::And(ba, hn::BitCast(d, low));
    out.channel[3] = hn::ShiftRight<16>(ba);
    return out;
}

/// bilinear() of gw/texels.h.
HWY_INLINE V32 bilinear_lanes(V32 a, V32 b, V32 c, V32 e, V32 wx, V32 wy, int bits) {
    const D32 d;
    if (bits == 8) {
        const I32 i;
        const auto s = [&](V32 v) { return hn::BitCast(i, v); };
        const auto half = hn::Set(i, 128), x = hn::ShiftLeft<6>(s(wx));
        const auto row = [&](V32 p, V32 q) {
            return hn::Add(hn::ShiftLeft<6>(s(p)),
                           hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(s(q), s(p)), x), half)));
        };
        const auto t0 = row(a, b), t1 = row(c, e);
        const auto t = hn::Add(t0, hn::ShiftRight<8>(hn::Add(hn::Mul(hn::Sub(t1, t0), s(wy)), half)));
        return hn::BitCast(d, hn::ShiftRight<6>(hn::Add(t, hn::Set(i, 32))));
    }
    const auto whole = hn::Set(d, 256u);
    const auto mix = [&](V32 p, V32 q, V32 w) {
        return hn::Add(hn::Mul(p, hn::Sub(whole, w)), hn::Mul(q, w));
    };
    return hn::ShiftRight<16>(hn::Add(mix(mix(a, b, wx), mix(c, e, wx), wy), hn::Set(d, 1u << 15)));
}

/// Level 0, one filter for all lanes.
HWY_INLINE void sample_level_0(const PrimitivePlanes& p, const DrawOp& op, bool linear, int bx, int by,
                               ColorBlock& out) {
    const D32 d;
    const TextureState& s = op.state.state.texture;
    const TexelLevel& level = op.texels->texels.levels[0];
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        const auto w = reciprocal_lanes(p.q, at);
        auto u = texel_coordinate(p.s, w, at), v = texel_coordinate(p.t, w, at);
        const auto index = [&](hn::Vec<I32> x, hn::Vec<I32> y) {
            return hn::Add(hn::Mul(wrap_lanes(s.wrap_t, y, level.height), hn::Set(I32(), level.width)),
                           wrap_lanes(s.wrap_s, x, level.width));
        };
        TexelLanes texel;
        if (!linear) {
            texel = fetch(*op.texels, index(hn::ShiftRight<8>(u), hn::ShiftRight<8>(v)));
        } else {
            const auto half = hn::Set(I32(), 128), one = hn::Set(I32(), 1), fraction = hn::Set(I32(), 255);
            u = hn::Sub(u, half), v = hn::Sub(v, half);
            const auto x0 = hn::ShiftRight<8>(u), y0 = hn::ShiftRight<8>(v);
            const auto x1 = hn::Add(x0, one), y1 = hn::Add(y0, one);
            const TexelLanes a = fetch(*op.texels, index(x0, y0)), b = fetch(*op.texels, index(x1, y0));
            const TexelLanes c = fetch(*op.texels, index(x0, y1)), e = fetch(*op.texels, index(x1, y1));
            const auto wx = hn::BitCast(d, hn::And(u, fraction)), wy = hn::BitCast(d, hn::And(v, fraction));
            for (std::size_t k = 0; k < 4; ++k)
                texel.channel[k] = bilinear_lanes(a.channel[k], b.channel[k], c.channel[k], e.channel[k], wx,
                                                  wy, op.state.bits);
        }
        for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], out.channel[k] + i);
    }
}

/// texture_environment() of gw/tables.h.
HWY_INLINE void apply_environment(TexEnv mode, const Rgba& env, int bits, const ColorBlock& texel,
                                  ColorBlock& color) {
    const D32 d;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto alpha = load_channel(texel.channel[3] + i);
        for (std::size_t c = 0; c < 4; ++c) {
            const auto f = load_channel(color.channel[c] + i), t = load_channel(texel.channel[c] + i);
            auto v = t;
            if (mode == TexEnv::Modulate || (mode == TexEnv::Blend && c == 3))
                v = mul_lanes(f, t, bits);
            else if (mode == TexEnv::Decal)
                v = c == 3 ? f : hn::Add(mul_lanes(f, hn::Sub(max, alpha), bits), mul_lanes(t, alpha, bits));
            else if (mode == TexEnv::Blend)
                v = hn::Add(mul_lanes(f, hn::Sub(max, t), bits), mul_lanes(hn::Set(d, env[c]), t, bits));
            store16(v, color.channel[c] + i);
        }
    }
}

// --- Fog
// --------------------------------------------------------------------------------------------------------------

HWY_INLINE V32 fog_factor_lanes(const PrimitivePlanes& p, const DrawOp& op, Pixels at) {
    if (!op.fog_table) return narrow_plane(p.fog, at);
    const D32 d;
    const I32 i;
    const int steps = 1 << fog_table_log2(op.state.bits);
    const auto f = hn::Mul(hn::Mul(to_floats(wide_plane(p.fog, at)), reciprocal_lanes(p.q, at)),
                           hn::Set(F32(), p.fog_scale));
    const auto clamped = hn::Max(hn::Zero(F32()), hn::Min(f, hn::Set(F32(), float(steps * 256))));
    const auto position = hn::ConvertTo(i, clamped);
    const auto entry = hn::ShiftRight<8>(position),
               next = hn::Min(hn::Add(entry, hn::Set(i, 1)), hn::Set(i, steps));
    const auto a = hn::BitCast(i, hn::GatherIndex(d, op.fog_table->data(), entry));
    const auto b = hn::BitCast(i, hn::GatherIndex(d, op.fog_table->data(), next));
    const auto step = hn::Add(hn::Mul(hn::Sub(b, a), hn::And(position, hn::Set(i, 255))), hn::Set(i, 128));
    return hn::BitCast(d, hn::Add(a, hn::ShiftRight<8>(step)));
}

HWY_INLINE void apply_fog_block(const PrimitivePlanes& p, const DrawOp& op, int bx, int by,
                                ColorBlock& color) {
    const D32 d;
    const int bits = op.state.bits;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto f = fog_factor_lanes(p, op, pixels_of(bx, by, i));
        for (std::size_t c = 0; c < 3; ++c) {
            const auto own = mul_lanes(f, load_channel(color.channel[c] + i), bits);
            const auto fog = mul_lanes(hn::Sub(max, f), hn::Set(d, op.state.fog_color[c]), bits);
            store16(hn::Add(own, fog), color.channel[c] + i);
        }
    }
}

/// Colour, texture, fog, in that order.
HWY_INLINE void shade_color(const PrimitivePlanes& p, const TileDraw& draw, int bx, int by,
                            std::uint32_t mask, ColorBlock& out) {
    const DrawOp& op = *draw.op;
    interpolated_color(p, op.state.bits, bx, by, out);
    if (op.state.state.color_source == ColorSource::PolygonId) return;
    if (op.texels) {
        ColorBlock texel;
        const TextureState& s = op.state.state.texture;
        if (p.texture_by_pixel)
            sample_by_pixel(p, draw, bx, by, mask, texel);
        else
            sample_level_0(p, op, s.mag_filter == MagFilter::Linear, bx, by, texel);
        apply_environment(s.env, op.state.env_color, op.state.bits, texel, out);
    }
    if (op.state.state.fog.enable) apply_fog_block(p, op, bx, by, out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
