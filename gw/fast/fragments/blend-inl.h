// Writing colours to the frame buffer: blending, masks. docs/manual.md, "Fragment
// operations"; scalar twin: gw/reference/fragment.cpp. Does not test. Included once per Highway
// target.
#if defined(GW_FAST_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_BLEND_INL_H_
#undef GW_FAST_BLEND_INL_H_
#else
#define GW_FAST_BLEND_INL_H_
#endif

#include "gw/base/arithmetic.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/stages/resolve.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Both sides of a blend, by channel.
template <class V>
struct BlendLanes {
    V src[4], dst[4], constant[4];
};

/// The factor of channel c, as in gw/stages/tables.h.
template <class D, class V>
HWY_INLINE V blend_factor_lanes(D d, BlendFactor factor, const BlendLanes<V>& l, std::size_t c,
                                V max) {
    switch (factor) {
        case BlendFactor::Zero: return hn::Zero(d);
        case BlendFactor::One: return max;
        case BlendFactor::SrcColor: return l.src[c];
        case BlendFactor::OneMinusSrcColor: return hn::Sub(max, l.src[c]);
        case BlendFactor::DstColor: return l.dst[c];
        case BlendFactor::OneMinusDstColor: return hn::Sub(max, l.dst[c]);
        case BlendFactor::SrcAlpha: return l.src[3];
        case BlendFactor::OneMinusSrcAlpha: return hn::Sub(max, l.src[3]);
        case BlendFactor::DstAlpha: return l.dst[3];
        case BlendFactor::OneMinusDstAlpha: return hn::Sub(max, l.dst[3]);
        case BlendFactor::SrcAlphaSaturate:
            return c == 3 ? max : hn::Min(l.src[3], hn::Sub(max, l.dst[3]));
        case BlendFactor::ConstantColor: return l.constant[c];
        case BlendFactor::OneMinusConstantColor: return hn::Sub(max, l.constant[c]);
        case BlendFactor::ConstantAlpha: return l.constant[3];
        case BlendFactor::OneMinusConstantAlpha: return hn::Sub(max, l.constant[3]);
    }
    return max;
}

/// Joins the products s and t of channel c.
template <class V>
HWY_INLINE V join_lanes(BlendEquation equation, const BlendLanes<V>& l, std::size_t c, V s, V t,
                        V max) {
    switch (equation) {
        case BlendEquation::Add: return hn::Min(max, hn::Add(s, t));
        case BlendEquation::Subtract: return hn::Sub(hn::Max(s, t), t);
        case BlendEquation::ReverseSubtract: return hn::Sub(hn::Max(s, t), s);
        case BlendEquation::Min: return hn::Min(l.src[c], l.dst[c]);
        case BlendEquation::Max: return hn::Max(l.src[c], l.dst[c]);
    }
    return max;
}

/// 8 bits a channel: everything fits 16-bit lanes.
HWY_NOINLINE inline void blend_bytes(const Resolved& r, const ColorBlock& src,
                                     const ColorBlock& dst, ColorBlock& out) {
    const BlendRule rules[2] = {color_rule(r.state.blend), alpha_rule(r.state.blend)};
    const D16 d;
    const auto max = hn::Set(d, std::uint16_t{255});
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        BlendLanes<hn::Vec<D16>> l;
        for (std::size_t c = 0; c < 4; ++c) {
            l.src[c] = hn::Load(d, src.channel[c] + i);
            l.dst[c] = hn::Load(d, dst.channel[c] + i);
            l.constant[c] = hn::Set(d, r.blend_color[c]);
        }
        for (std::size_t c = 0; c < 4; ++c) {
            const BlendRule& b = rules[c == 3 ? 1 : 0];
            const auto s = mul_bytes(d, l.src[c], blend_factor_lanes(d, b.src, l, c, max));
            const auto t = mul_bytes(d, l.dst[c], blend_factor_lanes(d, b.dst, l, c, max));
            hn::Store(join_lanes(b.equation, l, c, s, t, max), d, out.channel[c] + i);
        }
    }
}

/// A vector of one channel of a block, or of two if it is wide enough.
using DRow = hn::CappedTag<std::uint16_t, 32>;

/// The alpha of each pixel in lanes i .. of a row.
HWY_INLINE hn::Vec<DRow> alphas_of(const ColorBlock& block, std::size_t i) {
    const DRow d;
    const std::uint16_t* alpha = block.channel[3] + i % block_pixels;
#if HWY_MAX_BYTES >= 64
    const auto own = hn::Load(hn::Half<DRow>(), alpha);
    return hn::Combine(d, own, own);
#else
    return hn::Load(d, alpha);
#endif
}

/// The blends that programs use most, after sums: transparency (SrcAlpha, OneMinusSrcAlpha), glow
/// (SrcAlpha, One) and products of colours (DstColor, Zero or Zero, SrcColor), as of light maps.
enum class CommonBlend { None, Transparency, Glow, Product };
HWY_INLINE CommonBlend common_blend(const Resolved& r) {
    using enum BlendFactor;
    const BlendState& b = r.state.blend;
    if (r.bits != 8 || !b.enable || b.equation != BlendEquation::Add || b.alpha.separate ||
        !r.writes_whole_color)
        return CommonBlend::None;
    if (b.src == SrcAlpha && b.dst == OneMinusSrcAlpha) return CommonBlend::Transparency;
    if (b.src == SrcAlpha && b.dst == One) return CommonBlend::Glow;
    const bool is_product =
        (b.src == DstColor && b.dst == Zero) || (b.src == Zero && b.dst == SrcColor);
    return is_product ? CommonBlend::Product : CommonBlend::None;
}

/// Joins the lanes of `mask` of all channels, a row at a time.
template <CommonBlend blend>
HWY_NOINLINE inline void blend_rows(const ColorBlock& src, ColorBlock& stored, std::uint32_t mask) {
    const DRow d;
    const auto max = hn::Set(d, std::uint16_t{255});
    const std::uint16_t* from = src.channel[0];
    std::uint16_t* to = stored.channel[0];
    for (std::size_t i = 0; i < 4 * block_pixels; i += hn::Lanes(d)) {
        auto own = hn::Load(d, from + i), other = hn::Load(d, to + i);
        if constexpr (blend == CommonBlend::Product) {
            own = mul_bytes(d, own, other);
        } else {
            const auto alpha = alphas_of(src, i);
            if constexpr (blend == CommonBlend::Transparency)
                other = mul_bytes(d, other, hn::Sub(max, alpha));
            own = hn::Min(max, hn::Add(mul_bytes(d, own, alpha), other));
        }
        store_lanes(own, lanes_of(d, mask | mask << block_pixels, i % block_pixels), d, to + i);
    }
}

HWY_NOINLINE inline void blend_block(const Resolved& r, const ColorBlock& src,
                                     const ColorBlock& dst, ColorBlock& out) {
    const int bits = r.bits;
    if (bits == 8) return blend_bytes(r, src, dst, out);
    const BlendRule rules[2] = {color_rule(r.state.blend), alpha_rule(r.state.blend)};
    const D32 d;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        BlendLanes<V32> l;
        for (std::size_t c = 0; c < 4; ++c) {
            l.src[c] = load_channel(src.channel[c] + i);
            l.dst[c] = load_channel(dst.channel[c] + i);
            l.constant[c] = hn::Set(d, r.blend_color[c]);
        }
        for (std::size_t c = 0; c < 4; ++c) {
            const BlendRule& b = rules[c == 3 ? 1 : 0];
            const auto s = mul_lanes(l.src[c], blend_factor_lanes(d, b.src, l, c, max), bits);
            const auto t = mul_lanes(l.dst[c], blend_factor_lanes(d, b.dst, l, c, max), bits);
            hn::Store(narrow(join_lanes(b.equation, l, c, s, t, max)), Half16(),
                      out.channel[c] + i);
        }
    }
}

/// A logical operation by its truth table.
HWY_NOINLINE inline void logic_block(const Resolved& r, const ColorBlock& src,
                                     const ColorBlock& dst, ColorBlock& out) {
    const D16 d;
    const auto table = unsigned(r.state.logic_op.op);
    const auto max = hn::Set(d, std::uint16_t(max_of_bits(r.bits)));
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < block_pixels; i += lanes16) {
            const auto s = hn::Load(d, src.channel[c] + i), t = hn::Load(d, dst.channel[c] + i);
            auto v = hn::Zero(d);
            if (table & 1) v = hn::Or(v, hn::And(s, t));
            if (table & 2) v = hn::Or(v, hn::AndNot(t, s));
            if (table & 4) v = hn::Or(v, hn::AndNot(s, t));
            if (table & 8) v = hn::Or(v, hn::Not(hn::Or(s, t)));
            hn::Store(hn::And(v, max), d, out.channel[c] + i);
        }
}

/// One, One is a saturating sum: the blend of the passes of [K3].
HWY_INLINE void add_block(int bits, const ColorBlock& src, const ColorBlock& dst, ColorBlock& out) {
    const D16 d;
    const auto max = hn::Set(d, std::uint16_t(max_of_bits(bits)));
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < block_pixels; i += lanes16) {
            const auto sum =
                hn::SaturatedAdd(hn::Load(d, src.channel[c] + i), hn::Load(d, dst.channel[c] + i));
            hn::Store(hn::Min(sum, max), d, out.channel[c] + i);
        }
}

/// The bits that are written, among those that are stored.
HWY_NOINLINE inline void merge_bits(const Resolved& r, const ColorBlock& src, const ColorBlock& dst,
                                    ColorBlock& out) {
    const D16 d;
    for (std::size_t c = 0; c < 4; ++c) {
        const auto bits = hn::Set(d, r.written_bits[c]);
        for (std::size_t i = 0; i < block_pixels; i += lanes16)
            hn::Store(hn::Or(hn::And(bits, hn::Load(d, src.channel[c] + i)),
                             hn::AndNot(bits, hn::Load(d, dst.channel[c] + i))),
                      d, out.channel[c] + i);
    }
}

/// Any blend or logical operation, through any colour mask.
HWY_NOINLINE inline void join_and_write(const Resolved& r, const ColorBlock& src, ColorBlock& dst,
                                        std::uint32_t mask) {
    ColorBlock joined;
    const ColorBlock* out = &src;
    if (r.state.blend.enable || r.state.logic_op.enable) {
        out = &joined;
        if (r.state.logic_op.enable)
            logic_block(r, src, dst, joined);
        else if (adds_colors(r.state.blend))
            add_block(r.bits, src, dst, joined);
        else
            blend_block(r, src, dst, joined);
    }
    if (r.writes_part_bits) {
        merge_bits(r, *out, dst, joined);
        out = &joined;
    }
    const D16 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto lanes = lanes_of(d, mask, i);
        for (std::size_t c = 0; c < 4; ++c)
            if (r.written_bits[c] != 0)
                store_lanes(hn::Load(d, out->channel[c] + i), lanes, d, dst.channel[c] + i);
    }
}

/// Inlined, so that the common blends do not pay for the registers of the others.
HWY_INLINE void write_color(const Resolved& r, const ColorBlock& src, ColorBlock& dst,
                            std::uint32_t mask) {
    switch (common_blend(r)) {
        case CommonBlend::Transparency:
            return blend_rows<CommonBlend::Transparency>(src, dst, mask);
        case CommonBlend::Glow: return blend_rows<CommonBlend::Glow>(src, dst, mask);
        case CommonBlend::Product: return blend_rows<CommonBlend::Product>(src, dst, mask);
        case CommonBlend::None: return join_and_write(r, src, dst, mask);
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
