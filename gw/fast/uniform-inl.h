// Blocks whose pixels all have one colour or one depth: what a Clear leaves, and a triangle of one colour
// that covers them. While they have, the value is kept and the planes are not written. Such blocks are made
// by clear_blocks() and by draws of draws_uniform(), and known to these and to read_colors(); everything else
// settles the planes that it touches first. Included once per Highway target.
#if defined(GW_FAST_UNIFORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNIFORM_INL_H_
#undef GW_FAST_UNIFORM_INL_H_
#else
#define GW_FAST_UNIFORM_INL_H_
#endif

#include "gw/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

HWY_INLINE void settle_color(UniformBlock& uniform, ColorBlock& block) {
    if (!uniform.one_color) return;
    const D16 d;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < block_pixels; i += lanes16)
            hn::Store(hn::Set(d, uniform.color[c]), d, block.channel[c] + i);
    uniform.one_color = 0;
}

HWY_INLINE void settle_depth(UniformBlock& uniform, DepthBlock& block) {
    if (!uniform.one_depth) return;
    const D32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32)
        hn::Store(hn::Set(d, uniform.depth), d, block.value + i);
    uniform.one_depth = 0;
}

HWY_INLINE void settle_tile(const Tile& tile, UniformPlanes which) {
    UniformPlanes& has = *tile.has_uniform;
    if (which.color && has.color) {
        for (std::size_t i = 0; i < tile.blocks(); ++i) settle_color(tile.uniform[i], tile.color[i]);
        has.color = false;
    }
    if (which.depth && has.depth) {
        for (std::size_t i = 0; i < tile.blocks(); ++i) settle_depth(tile.uniform[i], tile.depth[i]);
        has.depth = false;
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
