// All fragment stages on a block of 16 lanes: tests, stencil operations, depth, then blending of
// the lanes that pass. docs/manual.md, "Fragment operations"; scalar twin:
// gw/reference/fragment.cpp. Does not shade. Included once per Highway target.
#if defined(GW_FAST_FRAGMENTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_FRAGMENTS_INL_H_
#undef GW_FAST_FRAGMENTS_INL_H_
#else
#define GW_FAST_FRAGMENTS_INL_H_
#endif

#include "gw/fast/fragments/blend-inl.h"
#include "gw/fast/fragments/depth-inl.h"
#include "gw/fast/fragments/stencil-inl.h"
#include "gw/fast/plan/tile_draw.h"

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

/// Runs a block's fragments: `color()` shades them when the first stage needs it.
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
    if (!r.writes_color) return;
    if (!shaded) shaded = &color();
    write_color(r, *shaded, tile.color[block], alive);
    if (draws_to_both(r.state)) write_color(r, *shaded, tile.other_color[block], alive);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
