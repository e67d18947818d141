// The depth test over blocks that may have one depth: of no test, of a triangle that slopes, and of one that
// does not, which leaves the blocks that it covers uniform. Does not paint. Included once per Highway target.
#if defined(GW_FAST_UNIFORM_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNIFORM_DEPTH_INL_H_
#undef GW_FAST_UNIFORM_DEPTH_INL_H_
#else
#define GW_FAST_UNIFORM_DEPTH_INL_H_
#endif

#include "gw/fast/plain-inl.h"
#include "gw/fast/uniform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Each calls then(alive) with the lanes of a block that pass, a LaneSet or AllLanes, or not at all.
struct WithoutDepth {
    template <class Lanes, class Then>
    HWY_INLINE void operator()(UniformBlock&, DepthBlock&, const Lanes& lanes, const Then& then) const {
        then(lanes);
    }
};

/// Of a triangle whose depth changes from pixel to pixel.
template <class Compare>
struct SlopingDepth {
    const DepthWalk& walk;
    const Compare passes;
    const bool update;

    template <class Lanes, class Then>
    HWY_INLINE void operator()(UniformBlock& uniform, DepthBlock& block, const Lanes& lanes,
                               const Then& then) const {
        then(uniform.one_depth ? first(uniform, block, lanes)
                               : run_depth(walk, passes, update, lanes, block));
    }
    /// run_depth() where all pixels of the block have one depth.
    template <class Lanes>
    HWY_INLINE LaneSet first(UniformBlock& uniform, DepthBlock& block, const Lanes& lanes) const {
        const D32 d;
        const auto stored = hn::Set(d, uniform.depth);
        LaneSet alive;
        for (std::size_t k = 0; k < parts; ++k) {
            const auto z = walk.walk.at(k);
            alive.part[k] = among(lanes, k, passes(z, stored));
            if (update) hn::Store(hn::IfThenElse(alive.part[k], z, stored), d, block.value + k * lanes32);
        }
        uniform.one_depth = update ? 0 : 1;
        return alive;
    }
};

/// Of a triangle that has one depth.
template <class Compare>
struct LevelDepth {
    const std::uint32_t z;
    const Compare passes;
    const bool update;

    template <class Then>
    HWY_INLINE void operator()(UniformBlock& uniform, DepthBlock& block, AllLanes, const Then& then) const {
        if (!uniform.one_depth) return operator()(uniform, block, lane_set(all_lanes), then);
        if (!passes.of_one(z, uniform.depth)) return;
        if (update) uniform.depth = z;
        then(AllLanes{});
    }
    template <class Then>
    HWY_INLINE void operator()(UniformBlock& uniform, DepthBlock& block, const LaneSet& lanes,
                               const Then& then) const {
        const D32 d;
        if (uniform.one_depth && !passes.of_one(z, uniform.depth)) return;
        if (update) settle_depth(uniform, block);
        const LaneSet alive = uniform.one_depth ? lanes : compared(block, lanes);
        if (update && alive.bits() == all_lanes)
            uniform.depth = z, uniform.one_depth = 1;
        else if (update)
            for (std::size_t k = 0; k < parts; ++k)
                store_lanes(hn::Set(d, z), alive.part[k], d, block.value + k * lanes32);
        then(alive);
    }
    HWY_INLINE LaneSet compared(const DepthBlock& block, const LaneSet& lanes) const {
        const D32 d;
        LaneSet alive;
        for (std::size_t k = 0; k < parts; ++k)
            alive.part[k] = among(lanes, k, passes(hn::Set(d, z), hn::Load(d, block.value + k * lanes32)));
        return alive;
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
