// The depth test over blocks that may have one depth: no test, and the test of a level triangle.
// Blocks that a level triangle covers stay uniform. Does not paint. Included once per Highway
// target.
#if defined(GW_FAST_LEVEL_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_LEVEL_DEPTH_INL_H_
#undef GW_FAST_LEVEL_DEPTH_INL_H_
#else
#define GW_FAST_LEVEL_DEPTH_INL_H_
#endif

#include "gw/fast/fragments/depth-inl.h"
#include "gw/fast/uniform/uniform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// test_lanes() calls then(alive) with the lanes of a block that pass, if there are any.
/// whole_blocks() tests blocks of a group, all lanes of each, and updates the depths of those that
/// pass. The caller tests a block with an unknown result lane by lane.
struct WithoutDepth {
    template <class Then>
    HWY_INLINE void test_lanes(int, int, const LaneSet& lanes, const Then& then) const {
        then(lanes);
    }
    HWY_INLINE void start(int, int) const {}
    HWY_INLINE GroupVerdicts whole_blocks(UniformGroup&, int, int, std::uint32_t blocks) const {
        return {blocks, 0};
    }
};

/// The test of a triangle of one depth.
template <class Compare>
struct LevelDepth {
    const Tile& tile;
    const std::uint32_t z;
    const Compare passes;
    const bool update;

    template <class Then>
    HWY_INLINE void test_lanes(int bx, int by, const LaneSet& lanes, const Then& then) const {
        const D32 d;
        UniformGroup& group = tile.group(bx, by);
        const std::uint32_t i = tile.in_group(bx, by), bit = 1u << i;
        DepthBlock& block = tile.depth[tile.block(bx, by)];
        const bool one = (group.one_depth & bit) != 0;
        if (one && !passes.of_one(z, group.depth[i])) return;
        if (update || !one) write_back_depth(tile, bx, by);
        const LaneSet alive = one ? lanes : compared(block, lanes);
        if (update && alive.bits() == all_lanes) {
            group.depth[i] = z;
            group.one_depth = std::uint16_t(group.one_depth | bit);
        } else if (update)
            for (std::size_t k = 0; k < parts; ++k)
                store_lanes(hn::Set(d, z), alive.part[k], d, block.value + k * lanes32);
        then(alive);
    }
    HWY_INLINE void start(int, int) const {}
    HWY_INLINE GroupVerdicts whole_blocks(UniformGroup& group, int, int,
                                          std::uint32_t blocks) const {
        const auto passing = [&](V32 stored) { return passes(hn::Set(D32(), z), stored); };
        const std::uint32_t one = blocks & group.one_depth,
                            pass = one & blocks_where(group, passing);
        if (update && pass != 0) set_depths(group, pass, z);
        return {pass, blocks & ~one};
    }

private:
    HWY_INLINE LaneSet compared(const DepthBlock& block, const LaneSet& lanes) const {
        const D32 d;
        LaneSet alive;
        for (std::size_t k = 0; k < parts; ++k)
            alive.part[k] =
                among(lanes, k, passes(hn::Set(d, z), hn::Load(d, block.value + k * lanes32)));
        return alive;
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
