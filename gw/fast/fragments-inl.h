// The fragment stages on a block of 16 lanes: tests, stencil operations, depth, blending, masks.
// docs/manual.md, "Fragment operations"; scalar twin: gw/reference/fragment.cpp. Does not shade.
// Included once per Highway target.
#if defined(GW_FAST_FRAGMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FRAGMENTS_INL_H_
#undef GW_FAST_FRAGMENTS_INL_H_
#else
#define GW_FAST_FRAGMENTS_INL_H_
#endif

#include "gw/arithmetic.h"
#include "gw/fast/kernels.h"

#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::CappedTag<std::uint8_t, 16>;
using D16 = hn::CappedTag<std::uint16_t, 16>;
using D32 = hn::CappedTag<std::uint32_t, 16>;
using I32 = hn::Rebind<std::int32_t, D32>;
using F32 = hn::Rebind<float, D32>;
using Half16 = hn::Rebind<std::uint16_t, D32>;  // as many 16-bit lanes as D32 has 32-bit ones
using V32 = hn::Vec<D32>;
using M32 = hn::Mask<D32>;

constexpr std::uint32_t all_lanes = 0xFFFF;
inline constexpr std::size_t lanes32 = HWY_MAX_BYTES >= 64   ? 16
                                       : HWY_MAX_BYTES >= 32 ? 8
                                       : HWY_MAX_BYTES >= 16 ? 4
                                                             : 1;
inline constexpr std::size_t lanes16 = lanes32 == 1 ? 1 : lanes32 * 2 > 16 ? 16 : lanes32 * 2;
inline constexpr std::size_t lanes8 = lanes32 == 1 ? 1 : 16;

/// Lanes of a vector's mask, from bit `first` of a block's 16-bit mask.
template <class D>
HWY_INLINE hn::Mask<D> lanes_of(D d, std::uint32_t mask, std::size_t first) {
    const std::uint64_t bits = mask >> first;
    return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
}

/// A vector's mask as bits.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> m, std::size_t lanes) {
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, m, reinterpret_cast<std::uint8_t*>(&bits));
    return static_cast<std::uint32_t>(bits) & ((1u << lanes) - 1);
}

/// incoming func stored, as in gw/tables.h.
template <class D, class V>
HWY_INLINE hn::Mask<D> compare_lanes(D d, CompareFunc func, V incoming, V stored) {
    switch (func) {
        case CompareFunc::Never: return hn::FirstN(d, 0);
        case CompareFunc::Less: return hn::Lt(incoming, stored);
        case CompareFunc::Equal: return hn::Eq(incoming, stored);
        case CompareFunc::LEqual: return hn::Not(hn::Lt(stored, incoming));
        case CompareFunc::Greater: return hn::Lt(stored, incoming);
        case CompareFunc::NotEqual: return hn::Not(hn::Eq(incoming, stored));
        case CompareFunc::GEqual: return hn::Not(hn::Lt(incoming, stored));
        case CompareFunc::Always: break;
    }
    return hn::FirstN(d, hn::Lanes(d));
}

/// Which of the lanes in `mask` pass the alpha test.
HWY_INLINE std::uint32_t alpha_test(const Resolved& r, const ColorBlock& color, std::uint32_t mask) {
    const D16 d;
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto alpha = hn::Load(d, color.channel[3] + i);
        pass |=
            bits_of(d, compare_lanes(d, r.state.alpha.func, alpha, hn::Set(d, std::uint16_t(r.alpha_ref))),
                    lanes16)
            << i;
    }
    return pass & mask;
}

HWY_INLINE std::uint32_t stencil_test(const StencilFace& face, const StencilBlock& block,
                                      std::uint32_t mask) {
    if (face.func == StencilFunc::Always) return mask;
    const D8 d;
    const auto ref = hn::Set(d, std::uint8_t(std::uint32_t(face.ref) & face.mask));
    const auto cut = hn::Set(d, std::uint8_t(face.mask));
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes8) {
        const auto stored = hn::And(hn::Load(d, block.value + i), cut);
        pass |= bits_of(d, compare_lanes(d, face.func, ref, stored), lanes8) << i;
    }
    return pass & mask;
}

/// The operation's result on whole vectors; [GL11] 4.1.4, as in gw/tables.h.
template <class D, class V>
HWY_INLINE V stencil_lanes(D d, StencilOp op, V stored, V ref, V max) {
    const V one = hn::Set(d, std::uint8_t{1});
    switch (op) {
        case StencilOp::Keep: return stored;
        case StencilOp::Zero: return hn::Zero(d);
        case StencilOp::Replace: return hn::And(ref, max);
        case StencilOp::Incr: return hn::Min(hn::SaturatedAdd(stored, one), max);
        case StencilOp::Decr: return hn::SaturatedSub(stored, one);
        case StencilOp::Invert: return hn::AndNot(stored, max);
        case StencilOp::IncrWrap: return hn::And(hn::Add(stored, one), max);
        case StencilOp::DecrWrap: return hn::And(hn::Sub(stored, one), max);
    }
    return stored;
}

HWY_NOINLINE inline void change_stencil(const StencilFace& face, StencilOp op, std::uint32_t max,
                                        StencilBlock& block, std::uint32_t mask) {
    const D8 d;
    const auto ref = hn::Set(d, std::uint8_t(face.ref)), limit = hn::Set(d, std::uint8_t(max));
    const auto writable = hn::Set(d, std::uint8_t(face.write_mask));
    for (std::size_t i = 0; i < block_pixels; i += lanes8) {
        const auto stored = hn::Load(d, block.value + i);
        const auto result = stencil_lanes(d, op, stored, ref, limit);
        const auto merged = hn::Or(hn::AndNot(writable, stored), hn::And(writable, result));
        hn::Store(hn::IfThenElse(lanes_of(d, mask, i), merged, stored), d, block.value + i);
    }
}

HWY_INLINE void update_stencil(const StencilFace& face, StencilOp op, std::uint32_t max, StencilBlock& block,
                               std::uint32_t mask) {
    if (op != StencilOp::Keep && mask != 0 && face.write_mask != 0)
        change_stencil(face, op, max, block, mask);
}

HWY_INLINE std::uint32_t depth_test(DepthFunc func, const DepthBlock& incoming, const DepthBlock& stored,
                                    std::uint32_t mask) {
    if (func == DepthFunc::Always) return mask;
    const D32 d;
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto m = compare_lanes(d, func, hn::Load(d, incoming.value + i), hn::Load(d, stored.value + i));
        pass |= bits_of(d, m, lanes32) << i;
    }
    return pass & mask;
}

HWY_INLINE void write_depth(const DepthBlock& incoming, DepthBlock& stored, std::uint32_t mask) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        hn::BlendedStore(hn::Load(d, incoming.value + i), lanes_of(d, mask, i), d, stored.value + i);
}

// --- Blending
// -------------------------------------------------------------------------------------------------------

/// mul(a, b, n) of gw/arithmetic.h.
HWY_INLINE V32 mul_lanes(V32 a, V32 b, int n) {
    const D32 d;
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(d, 1u << (n - 1)));
    return hn::ShiftRightSame(hn::Add(t, hn::ShiftRightSame(t, n)), n);
}

/// The same for n = 8 in 16-bit lanes.
HWY_INLINE hn::Vec<D16> mul_bytes(hn::Vec<D16> a, hn::Vec<D16> b) {
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(D16(), std::uint16_t{128}));
    return hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
}

HWY_INLINE V32 load_channel(const std::uint16_t* p) { return hn::PromoteTo(D32(), hn::Load(Half16(), p)); }

HWY_INLINE hn::Vec<Half16> narrow(V32 v) { return hn::DemoteTo(Half16(), hn::BitCast(I32(), v)); }

/// Both sides of a blend, by channel.
template <class V>
struct BlendLanes {
    V src[4], dst[4];
};

/// The factor of channel c, as in gw/tables.h.
template <class D, class V>
HWY_INLINE V blend_factor_lanes(D d, BlendFactor factor, const BlendLanes<V>& l, std::size_t c, V max) {
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
        case BlendFactor::SrcAlphaSaturate: return c == 3 ? max : hn::Min(l.src[3], hn::Sub(max, l.dst[3]));
    }
    return max;
}

/// 8 bits a channel: everything fits 16-bit lanes.
HWY_INLINE void blend_bytes(BlendFactor src_factor, BlendFactor dst_factor, const ColorBlock& src,
                            const ColorBlock& dst, ColorBlock& out) {
    const D16 d;
    const auto max = hn::Set(d, std::uint16_t{255});
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        BlendLanes<hn::Vec<D16>> l;
        for (std::size_t c = 0; c < 4; ++c)
            l.src[c] = hn::Load(d, src.channel[c] + i), l.dst[c] = hn::Load(d, dst.channel[c] + i);
        for (std::size_t c = 0; c < 4; ++c) {
            const auto s = mul_bytes(l.src[c], blend_factor_lanes(d, src_factor, l, c, max));
            const auto t = mul_bytes(l.dst[c], blend_factor_lanes(d, dst_factor, l, c, max));
            hn::Store(hn::Min(max, hn::Add(s, t)), d, out.channel[c] + i);
        }
    }
}

/// Transparency, the commonest blend after the sum, with its factors known where the code is compiled.
HWY_NOINLINE inline void blend_bytes(const BlendState& b, const ColorBlock& src, const ColorBlock& dst,
                                     ColorBlock& out) {
    if (b.src == BlendFactor::SrcAlpha && b.dst == BlendFactor::OneMinusSrcAlpha)
        blend_bytes(BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha, src, dst, out);
    else
        blend_bytes(b.src, b.dst, src, dst, out);
}

HWY_NOINLINE inline void blend_block(const BlendState& b, int bits, const ColorBlock& src,
                                     const ColorBlock& dst, ColorBlock& out) {
    if (bits == 8) return blend_bytes(b, src, dst, out);
    const D32 d;
    const auto max = hn::Set(d, max_of_bits(bits));
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        BlendLanes<V32> l;
        for (std::size_t c = 0; c < 4; ++c) {
            l.src[c] = load_channel(src.channel[c] + i);
            l.dst[c] = load_channel(dst.channel[c] + i);
        }
        for (std::size_t c = 0; c < 4; ++c) {
            const auto s = mul_lanes(l.src[c], blend_factor_lanes(d, b.src, l, c, max), bits);
            const auto t = mul_lanes(l.dst[c], blend_factor_lanes(d, b.dst, l, c, max), bits);
            hn::Store(narrow(hn::Min(max, hn::Add(s, t))), Half16(), out.channel[c] + i);
        }
    }
}

/// One, One is a saturating sum: what the passes of [K3] do all the time.
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

HWY_NOINLINE inline void write_color(const Resolved& r, const ColorBlock& src, ColorBlock& dst,
                                     std::uint32_t mask) {
    const BlendState& b = r.state.blend;
    ColorBlock blended;
    const ColorBlock* out = &src;
    if (b.enable) {
        out = &blended;
        if (b.src == BlendFactor::One && b.dst == BlendFactor::One)
            add_block(r.bits, src, dst, blended);
        else
            blend_block(b, r.bits, src, dst, blended);
    }
    const ColorMask& m = r.state.color_mask;
    const bool channel[4] = {m.r, m.g, m.b, m.a};
    const D16 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto lanes = lanes_of(d, mask, i);
        for (std::size_t c = 0; c < 4; ++c)
            if (channel[c]) hn::BlendedStore(hn::Load(d, out->channel[c] + i), lanes, d, dst.channel[c] + i);
    }
}

// --- The order of the stages
// ------------------------------------------------------------------------------------------

/// A block's fragments on their way: `color()` shades them when the first stage needs it.
template <class Shade>
HWY_INLINE void run_fragments(const Resolved& r, bool front, const DepthBlock& depth, const Tile& tile,
                              std::size_t block, std::uint32_t mask, OpCounts& counts, const Shade& color) {
    const auto count = [](std::uint32_t m) { return std::uint64_t(std::popcount(m)); };
    const StencilFace& face = front ? r.front : r.back;
    StencilBlock& stencil = tile.stencil[block];
    const ColorBlock* shaded = nullptr;
    counts.fragments += count(mask);

    if (r.state.alpha.func != AlphaFunc::Always) {
        shaded = &color();
        const std::uint32_t pass = alpha_test(r, *shaded, mask);
        counts.alpha_killed += count(mask & ~pass);
        mask = pass;
    }
    const std::uint32_t stencil_pass = stencil_test(face, stencil, mask);
    if (stencil_pass != mask) {
        counts.stencil_killed += count(mask & ~stencil_pass);
        update_stencil(face, face.fail, r.stencil_max, stencil, mask & ~stencil_pass);
    }
    const std::uint32_t alive = depth_test(r.state.depth.func, depth, tile.depth[block], stencil_pass);
    counts.depth_killed += count(stencil_pass & ~alive);
    update_stencil(face, face.zfail, r.stencil_max, stencil, stencil_pass & ~alive);
    update_stencil(face, face.zpass, r.stencil_max, stencil, alive);
    counts.written += count(alive);
    if (alive == 0) return;
    if (r.state.depth.mask) write_depth(depth, tile.depth[block], alive);
    if (r.writes_color) write_color(r, shaded ? *shaded : color(), tile.color[block], alive);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
