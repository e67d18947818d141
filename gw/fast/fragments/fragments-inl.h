// The fragment stages on a block of 16 lanes: tests, stencil operations, depth, and what is left to
// be blended. docs/manual.md, "Fragment operations"; scalar twin: gw/reference/fragment.cpp. Does
// not shade.
// Included once per Highway target.
#if defined(GW_FAST_FRAGMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FRAGMENTS_INL_H_
#undef GW_FAST_FRAGMENTS_INL_H_
#else
#define GW_FAST_FRAGMENTS_INL_H_
#endif

#include "gw/fast/fragments/blend-inl.h"
#include "gw/fast/kernels.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Which of the lanes in `mask` pass the alpha test.
HWY_INLINE std::uint32_t alpha_test(const Resolved& r, const ColorBlock& color,
                                    std::uint32_t mask) {
    const D16 d;
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes16) {
        const auto alpha = hn::Load(d, color.channel[3] + i);
        pass |= bits_of(d,
                        compare_lanes(d, r.state.alpha.func, alpha,
                                      hn::Set(d, std::uint16_t(r.alpha_ref))),
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

/// The operation's result on whole vectors; [GL11] 4.1.4, as in gw/stages/tables.h.
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

HWY_INLINE void update_stencil(const StencilFace& face, StencilOp op, std::uint32_t max,
                               StencilBlock& block, std::uint32_t mask) {
    if (op != StencilOp::Keep && mask != 0 && face.write_mask != 0)
        change_stencil(face, op, max, block, mask);
}

HWY_INLINE std::uint32_t depth_test(DepthFunc func, const DepthBlock& incoming,
                                    const DepthBlock& stored, std::uint32_t mask) {
    if (func == DepthFunc::Always) return mask;
    const D32 d;
    std::uint32_t pass = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto m =
            compare_lanes(d, func, hn::Load(d, incoming.value + i), hn::Load(d, stored.value + i));
        pass |= bits_of(d, m, lanes32) << i;
    }
    return pass & mask;
}

HWY_INLINE void write_depth(const DepthBlock& incoming, DepthBlock& stored, std::uint32_t mask) {
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        store_lanes(hn::Load(d, incoming.value + i), lanes_of(d, mask, i), d, stored.value + i);
}

/// A block's fragments on their way: `color()` shades them when the first stage needs it.
template <class Shade>
HWY_INLINE void run_fragments(const Resolved& r, bool front, const DepthBlock& depth,
                              const Tile& tile, std::size_t block, std::uint32_t mask,
                              OpCounts& counts, const Shade& color) {
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
    const std::uint32_t alive =
        depth_test(r.state.depth.func, depth, tile.depth[block], stencil_pass);
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
