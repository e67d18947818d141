// Selects the triangles for the simple path and counts their fragments lane by lane. Does not draw.
// Included once per Highway target.
#if defined(GW_FAST_LANE_COUNTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_LANE_COUNTS_INL_H_
#undef GW_FAST_LANE_COUNTS_INL_H_
#else
#define GW_FAST_LANE_COUNTS_INL_H_
#endif

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/simd/walk-inl.h"
#include "gw/fast/vertices/geometry.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a draw consists of filled triangles.
HWY_INLINE bool is_filled(const DrawOp& op) {
    return op.set->triangle_count == op.set->primitives.size();
}
/// Whether any of a draw's primitives is antialiased.
HWY_INLINE bool antialiases(const DrawOp& op) {
    const State& s = op.state.state;
    return is_filled(op) ? s.polygon_smooth : gw::antialiases(s);
}
/// Whether a draw's triangles take the simple path.
HWY_INLINE bool takes_simple_path(const DrawOp& op) {
    const Resolved& r = op.state;
    return r.state.alpha.func == AlphaFunc::Always && !r.state.polygon_stipple.pattern &&
           !antialiases(op) && !draws_to_both(r.state);
}

/// A triangle's fragments by fate, lane by lane.
struct LaneCounts {
    LaneCounter made, stencil_passed, written;

    HWY_INLINE void clear() {
        made.clear();
        stencil_passed.clear();
        written.clear();
    }
    HWY_INLINE void add_to(LaneCounts& sum) const {
        sum.made.add(made);
        sum.stencil_passed.add(stencil_passed);
        sum.written.add(written);
    }
    HWY_INLINE void add_to(OpCounts& counts) const {
        const std::uint64_t f = made.total(), s = stencil_passed.total(), w = written.total();
        counts.fragments += f;
        counts.stencil_killed += f - s;
        counts.depth_killed += s - w;
        counts.written += w;
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
