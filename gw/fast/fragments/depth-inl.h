// The depth test, on blocks and on vectors. docs/manual.md, "Fragment operations"; scalar twin:
// gw/reference/fragment.cpp. Three special cases with the same result test whole blocks:
// gw/fast/uniform/level_depth-inl.h, a triangle of one depth over blocks of one depth;
// gw/fast/uniform/sloping_depth-inl.h, a sloping triangle over blocks of one depth or one plane;
// gw/fast/visible/record.cpp, a depth pass that also records ties. Does not paint. Included once
// per Highway target.
#if defined(GW_FAST_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_DEPTH_INL_H_
#undef GW_FAST_DEPTH_INL_H_
#else
#define GW_FAST_DEPTH_INL_H_
#endif

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/stages/tables.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The general test: which lanes of `mask` pass.
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

/// The test of simple triangles, in three kinds so that the loop has no branch.
struct NoDepth {
    static constexpr bool tests = false;
    HWY_INLINE M32 operator()(V32, V32) const { return hn::FirstN(D32(), lanes32); }
};
struct LessThan {
    static constexpr bool tests = true;
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const { return hn::Lt(incoming, stored); }
    HWY_INLINE bool of_one(std::uint32_t incoming, std::uint32_t stored) const {
        return incoming < stored;
    }
};
/// Any test, as sums modulo 2 of the incoming depth being less, being equal, and 1: without
/// branches.
struct AnyCompare {
    static constexpr bool tests = true;
    DepthFunc func;
    M32 less, equal, always;

    HWY_INLINE explicit AnyCompare(DepthFunc f)
        : func(f),
          less(all_if(f == DepthFunc::Less || f == DepthFunc::LEqual || f == DepthFunc::Greater ||
                      f == DepthFunc::GEqual)),
          equal(all_if(f == DepthFunc::Equal || f == DepthFunc::LEqual || f == DepthFunc::Greater ||
                       f == DepthFunc::NotEqual)),
          always(all_if(f == DepthFunc::Always || f == DepthFunc::Greater ||
                        f == DepthFunc::NotEqual || f == DepthFunc::GEqual)) {}
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const {
        return hn::Xor(hn::Xor(hn::And(less, hn::Lt(incoming, stored)),
                               hn::And(equal, hn::Eq(incoming, stored))),
                       always);
    }
    HWY_INLINE bool of_one(std::uint32_t incoming, std::uint32_t stored) const {
        return compare(func, incoming, stored);
    }

private:
    HWY_INLINE static M32 all_if(bool all) { return hn::FirstN(D32(), all ? lanes32 : 0); }
};

/// Calls draw(passes) with the kind of a draw.
template <class Draw>
HWY_INLINE void with_depth_test(const DrawOp& op, const Draw& draw) {
    const DepthFunc func = op.state.state.depth.func;
    if (func == DepthFunc::Less)
        draw(LessThan{});
    else if (!needs_depth(op))
        draw(NoDepth{});
    else
        draw(AnyCompare{func});
}

/// Depth test and update of the lanes, a LaneSet or AllLanes; those that pass.
template <class Compare, class Lanes>
HWY_INLINE LaneSet run_depth(const DepthWalk& walk, const Compare& passes, bool update,
                             const Lanes& lanes, DepthBlock& block) {
    const D32 d;
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        std::uint32_t* stored = block.value + k * lanes32;
        const auto z = walk.walk.at(k);
        alive.part[k] = among(lanes, k, passes(z, hn::Load(d, stored)));
        if (update) store_lanes(z, alive.part[k], d, stored);
    }
    return alive;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
