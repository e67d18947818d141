// Clearing a tile's colours and depths. docs/manual.md, "Pixels"; scalar twin: gw/reference/pixels.cpp. Does
// not clear stencils or sums.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/clear.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/kernels.h"
#include "gw/fast/lanes-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The lanes of `mask` of one block's values; whole blocks are the rule.
template <class D, class T>
HWY_INLINE void fill(D d, T (&values)[block_pixels], T value, std::uint32_t mask) {
    const auto v = hn::Set(d, value);
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(d)) {
        if (mask == all_lanes)
            hn::Store(v, d, values + i);
        else
            store_lanes(v, lanes_of(d, mask, i), d, values + i);
    }
}

void clear_all(const ClearBlocks& clear) {
    const BlockBox& box = clear.box;
    for (int by = box.y0 / block_side; by * block_side < box.y1; ++by)
        for (int bx = box.x0 / block_side; bx * block_side < box.x1; ++bx) {
            const std::size_t block = clear.tile.block(bx, by);
            const std::uint32_t mask = box.mask(bx, by);
            for (std::size_t c = 0; c < 4; ++c)
                if (clear.channel[c]) fill(D16(), clear.tile.color[block].channel[c], clear.color[c], mask);
            if (clear.clears_depth) fill(D32(), clear.tile.depth[block].value, clear.depth, mask);
        }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(clear_all);

void clear_blocks(const ClearBlocks& clear) { HWY_DYNAMIC_DISPATCH(clear_all)(clear); }

}  // namespace gw::fast
#endif  // HWY_ONCE
