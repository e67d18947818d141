// Triangles that no colour is asked of: depth passes, shadow maps, shadow volumes. Tests, stencil operations
// and depth writes on vectors of 32-bit lanes, without leaving them. docs/manual.md, "Fragment operations";
// the general way is gw/fast/fragments-inl.h. Included once per Highway target.
#if defined(GW_FAST_UNCOLORED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_UNCOLORED_INL_H_
#undef GW_FAST_UNCOLORED_INL_H_
#else
#define GW_FAST_UNCOLORED_INL_H_
#endif

#include "gw/fast/cover-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Whether a draw only tests and writes depth and stencil.
HWY_INLINE bool is_uncolored(const Resolved& r) {
    return !r.writes_color && r.state.alpha.func == AlphaFunc::Always && !r.state.polygon_offset.enable;
}

HWY_INLINE bool is_idle(const StencilFace& f) { return f.func == StencilFunc::Always && keeps(f); }

/// One face's stencil state on vectors of 32-bit lanes.
struct StencilLanes {
    using Quarter8 = hn::Rebind<std::uint8_t, D32>;
    const StencilFace& face;
    V32 ref, test_ref, test_mask, max, write_mask;

    HWY_INLINE StencilLanes(const StencilFace& f, std::uint32_t stencil_max) : face(f) {
        const D32 d;
        ref = hn::Set(d, std::uint32_t(f.ref) & 255), max = hn::Set(d, stencil_max);
        test_mask = hn::Set(d, f.mask & 255), write_mask = hn::Set(d, f.write_mask & 255);
        test_ref = hn::And(ref, test_mask);
    }
    HWY_INLINE static V32 load(const std::uint8_t* p) {
        return hn::PromoteTo(D32(), hn::Load(Quarter8(), p));
    }
    HWY_INLINE static void store(V32 v, std::uint8_t* p) {
        hn::Store(hn::DemoteTo(Quarter8(), hn::BitCast(I32(), v)), Quarter8(), p);
    }
    HWY_INLINE M32 test(V32 stored) const {
        return compare_lanes(D32(), face.func, test_ref, hn::And(stored, test_mask));
    }
    /// stencil_lanes() of gw/fast/fragments-inl.h, which saturates bytes.
    HWY_INLINE V32 result(StencilOp op, V32 stored) const {
        const D32 d;
        const auto one = hn::Set(d, 1u);
        switch (op) {
            case StencilOp::Keep: return stored;
            case StencilOp::Zero: return hn::Zero(d);
            case StencilOp::Replace: return hn::And(ref, max);
            case StencilOp::Incr: return hn::Min(hn::Add(stored, one), max);
            case StencilOp::Decr: return hn::Sub(hn::Max(stored, one), one);
            case StencilOp::Invert: return hn::AndNot(stored, max);
            case StencilOp::IncrWrap: return hn::And(hn::Add(stored, one), max);
            case StencilOp::DecrWrap: return hn::And(hn::Sub(stored, one), max);
        }
        return stored;
    }
    /// What is stored after `op`, bits outside the write mask kept.
    HWY_INLINE V32 after(StencilOp op, V32 stored) const {
        if (op == StencilOp::Keep) return stored;
        return hn::Or(hn::AndNot(write_mask, stored), hn::And(write_mask, result(op, stored)));
    }
};

/// Fragments of a batch by fate, lane by lane.
struct UncoloredCounts {
    LaneCounter made, stencil_passed, written;
    HWY_INLINE void clear() { made.clear(), stencil_passed.clear(), written.clear(); }
    HWY_INLINE void add_to(OpCounts& counts) const {
        const std::uint64_t f = made.total(), s = stencil_passed.total(), w = written.total();
        counts.fragments += f, counts.stencil_killed += f - s, counts.depth_killed += s - w,
            counts.written += w;
    }
};

/// Less is what nearly every draw compares: without a choice in the loop.
struct LessThan {
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const { return hn::Lt(incoming, stored); }
};
struct AnyCompare {
    DepthFunc func;
    HWY_INLINE M32 operator()(V32 incoming, V32 stored) const {
        return compare_lanes(D32(), func, incoming, stored);
    }
};

/// Depth test and update of the lanes; those that pass.
template <class Compare>
HWY_INLINE LaneSet run_depth(const DepthWalk& walk, const Compare& passes, bool update, const LaneSet& lanes,
                             DepthBlock& block) {
    const D32 d;
    LaneSet alive;
    for (std::size_t k = 0; k < parts; ++k) {
        std::uint32_t* stored = block.value + k * lanes32;
        const auto z = walk.walk.at(k);
        alive.part[k] = hn::And(lanes.part[k], passes(z, hn::Load(d, stored)));
        if (update) hn::BlendedStore(z, alive.part[k], d, stored);
    }
    return alive;
}

/// The same behind a stencil test, with the three operations.
template <class Compare>
HWY_INLINE void run_stencil(const StencilLanes& s, const DepthWalk& walk, const Compare& passes, bool update,
                            const LaneSet& lanes, StencilBlock& stencil, DepthBlock& depth,
                            UncoloredCounts& counts) {
    V32 stored[parts];
    LaneSet tested;
    for (std::size_t k = 0; k < parts; ++k) {
        stored[k] = StencilLanes::load(stencil.value + k * lanes32);
        tested.part[k] = hn::And(lanes.part[k], s.test(stored[k]));
    }
    const LaneSet alive = run_depth(walk, passes, update, tested, depth);
    for (std::size_t k = 0; k < parts; ++k) {
        auto v = hn::IfThenElse(lanes.part[k], s.after(s.face.fail, stored[k]), stored[k]);
        v = hn::IfThenElse(tested.part[k], s.after(s.face.zfail, stored[k]), v);
        v = hn::IfThenElse(alive.part[k], s.after(s.face.zpass, stored[k]), v);
        StencilLanes::store(v, stencil.value + k * lanes32);
    }
    counts.made.add(lanes);
    counts.stencil_passed.add(tested);
    counts.written.add(alive);
}

template <class Compare>
HWY_INLINE void draw_uncolored(const TileDraw& draw, const Triangles& t, std::size_t i, const BoxLanes& box,
                               const Compare& passes, UncoloredCounts& counts) {
    const Resolved& r = draw.op->state;
    const DepthPlane plane = depth_of(draw, t, i);
    DepthWalk walk{plane, 0, {}};
    const StencilFace& face = t.corners.primitive[i]->front ? r.front : r.back;
    const bool update = r.state.depth.mask;
    if (is_idle(face)) {
        visit_triangle(box, t, i, walk, [&](int bx, int by, const LaneSet& lanes) {
            const LaneSet alive =
                run_depth(walk, passes, update, lanes, draw.tile.depth[draw.tile.block(bx, by)]);
            counts.made.add(lanes), counts.stencil_passed.add(lanes), counts.written.add(alive);
        });
        return;
    }
    const StencilLanes stencil(face, r.stencil_max);
    visit_triangle(box, t, i, walk, [&](int bx, int by, const LaneSet& lanes) {
        const std::size_t block = draw.tile.block(bx, by);
        run_stencil(stencil, walk, passes, update, lanes, draw.tile.stencil[block], draw.tile.depth[block],
                    counts);
    });
}

/// Draws a batch of triangles.
HWY_INLINE void draw_uncolored(const TileDraw& draw, std::span<const std::uint32_t> bin, OpCounts& counts) {
    const DepthFunc func = draw.op->state.state.depth.func;
    const BoxLanes box(draw);
    Triangles t;
    UncoloredCounts lanes;
    lanes.clear();
    set_up_triangles(draw, bin, true, t);
    for (std::size_t i = 0; i < t.count(); ++i) {
        if (t.empty(i)) continue;
        if (func == DepthFunc::Less)
            draw_uncolored(draw, t, i, box, LessThan{}, lanes);
        else
            draw_uncolored(draw, t, i, box, AnyCompare{func}, lanes);
    }
    lanes.add_to(counts);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
