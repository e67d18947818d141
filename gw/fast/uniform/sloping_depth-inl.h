// The depth test of a sloping triangle over blocks that may have one depth or the depths of one
// plane. If the whole block passes, it stores the triangle's plane. Two planes are compared by
// their difference at a block's corners. Does not paint. Included once per Highway target.
#if defined(GW_FAST_SLOPING_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SLOPING_DEPTH_INL_H_
#undef GW_FAST_SLOPING_DEPTH_INL_H_
#else
#define GW_FAST_SLOPING_DEPTH_INL_H_
#endif

#include "gw/fast/fragments/depth-inl.h"
#include "gw/fast/raster/cover-inl.h"
#include "gw/fast/uniform/uniform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// A plane of depths that does not wrap: all its terms at covered pixels stay below 2^56.
struct ExactPlane {
    std::int64_t c, gx, gy;

    HWY_INLINE explicit ExactPlane(const TilePlane& p)
        : c(static_cast<std::int64_t>(p.c)), gx(p.gx), gy(p.gy) {}
    HWY_INLINE static bool applies_to(const TilePlane& p) {
        const auto fits = [](std::int64_t g) { return std::abs(g) < std::int64_t{1} << 47; };
        return !p.sliver && fits(p.gx) && fits(p.gy);
    }
    HWY_INLINE ExactPlane minus(const ExactPlane& p) const {
        ExactPlane difference = *this;
        difference.c -= p.c;
        difference.gx -= p.gx;
        difference.gy -= p.gy;
        return difference;
    }
};

/// How a triangle's depths compare with the stored ones at all pixels of a range.
enum class Order { Unknown, Less, Equal, Greater };

/// The order of two planes from their difference before rounding. Unless they are equal, it is
/// unknown if they differ by less than 1 at a pixel.
HWY_INLINE Order order_of(const ExactPlane& difference, const BlockRange& r) {
    const std::int64_t corner = difference.c + difference.gx * (block_side * std::int64_t{r.x0}) +
                                difference.gy * (block_side * std::int64_t{r.y0});
    const std::int64_t across = difference.gx * (block_side * std::int64_t{r.x1 - r.x0 + 1} - 1),
                       along = difference.gy * (block_side * std::int64_t{r.y1 - r.y0 + 1} - 1);
    const std::int64_t zero = 0;
    if ((difference.c | difference.gx | difference.gy) == 0) return Order::Equal;
    if (corner + std::max(across, zero) + std::max(along, zero) <= -65536) return Order::Less;
    if (corner + std::min(across, zero) + std::min(along, zero) >= 65536) return Order::Greater;
    return Order::Unknown;
}

/// A triangle's depth, moving with its blocks, and bounds for the whole triangle.
struct SlopingWalk : DepthWalk {
    /// Bounds of its depths at all pixels that it covers: all 32 bits if they are unknown, or if a
    /// block may not store its plane.
    std::uint32_t least = 0, most = ~0u;
    std::uint32_t stored = ~0u;  ///< its index in the tile's depth planes

    HWY_INLINE explicit SlopingWalk(const DepthPlane& p) : DepthWalk(p) {}

    /// The corners' depths, widened by 1: is_near().
    HWY_INLINE void find_bounds(const Corners& t, std::size_t i) {
        const std::uint32_t low = std::min({t.z[0][i], t.z[1][i], t.z[2][i]}),
                            high = std::max({t.z[0][i], t.z[1][i], t.z[2][i]});
        if (low == 0 || high == ~0u || !is_near(t, i)) return;
        if (!ExactPlane::applies_to(plane.plane)) return;
        least = low - 1;
        most = high + 1;
    }
    HWY_INLINE bool may_be_stored() const { return most != ~0u || least != 0; }

    HWY_INLINE std::uint32_t store_plane(const Tile& tile) {
        if (stored == ~0u) {
            stored = std::uint32_t(tile.depth_planes->size());
            tile.depth_planes->push_back(plane.plane);
        }
        return stored;
    }
};

/// The depth test of a sloping triangle; see WithoutDepth.
template <class Compare>
struct SlopingDepth {
    const Tile& tile;
    SlopingWalk& walk;
    const Compare passes;
    const bool update;

    template <class Then>
    HWY_INLINE void test_lanes(int bx, int by, const LaneSet& lanes, const Then& then) const {
        UniformGroup& group = tile.group(bx, by);
        const std::uint32_t i = tile.in_group(bx, by);
        DepthBlock& block = tile.depth[tile.block(bx, by)];
        LaneSet alive;
        if (group.one_depth >> i & 1) {
            alive = first(group, i, block, lanes);
        } else {
            if (group.one_plane >> i & 1) write_back_depth(tile, bx, by);
            alive = run_depth(walk, passes, update, lanes, block);
        }
        then(alive);
    }
    HWY_INLINE void start(int bx, int by) const { walk.start(bx, by); }

    HWY_INLINE GroupVerdicts whole_blocks(UniformGroup& group, int x, int y,
                                          std::uint32_t blocks) const {
        const D32 d;
        const auto below = [&](V32 stored) { return hn::Lt(hn::Set(d, walk.most), stored); };
        const auto above = [&](V32 stored) { return hn::Lt(stored, hn::Set(d, walk.least)); };
        const std::uint32_t one = blocks & group.one_depth;
        GroupVerdicts out{0, blocks & ~group.one_plane};
        decide(Order::Less, one & blocks_where(group, below), out);
        decide(Order::Greater, one & blocks_where(group, above), out);
        if ((blocks & group.one_plane) != 0)
            compare_planes(group, x, y, blocks & group.one_plane, out);
        if (update && out.pass != 0) {
            set_depths(group, out.pass, walk.store_plane(tile));
            group.one_depth = std::uint16_t(group.one_depth & ~out.pass);
            group.one_plane = std::uint16_t(group.one_plane | out.pass);
        }
        return out;
    }

private:
    /// The verdict for blocks in this order.
    HWY_INLINE void decide(Order order, std::uint32_t blocks, GroupVerdicts& out) const {
        if (order == Order::Unknown) return void(out.unknown |= blocks);
        out.unknown &= ~blocks;
        const std::uint32_t incoming = order == Order::Greater, stored = order == Order::Less;
        if (passes.of_one(incoming, stored)) out.pass |= blocks;
    }
    /// Compares blocks that store planes, plane by plane. Few groups have more than one plane.
    HWY_NOINLINE void compare_planes(const UniformGroup& group, int x, int y, std::uint32_t blocks,
                                     GroupVerdicts& out) const {
        if (!walk.may_be_stored()) return decide(Order::Unknown, blocks, out);
        const ExactPlane own(walk.plane.plane);
        while (blocks != 0) {
            const std::uint32_t index = group.depth[std::countr_zero(blocks)];
            const auto same = [&](V32 stored) { return hn::Eq(stored, hn::Set(D32(), index)); };
            const std::uint32_t of_plane = blocks & blocks_where(group, same);
            const ExactPlane difference = own.minus(ExactPlane((*tile.depth_planes)[index]));
            decide(order_of(difference, {x, y, x + group_blocks - 1, y + group_blocks - 1}),
                   of_plane, out);
            blocks &= ~of_plane;
        }
    }
    /// run_depth() if all pixels of the block have one depth.
    HWY_INLINE LaneSet first(UniformGroup& group, std::uint32_t i, DepthBlock& block,
                             const LaneSet& lanes) const {
        const D32 d;
        const auto stored = hn::Set(d, group.depth[i]);
        LaneSet alive;
        for (std::size_t k = 0; k < parts; ++k) {
            const auto z = walk.walk.at(k);
            alive.part[k] = among(lanes, k, passes(z, stored));
            if (update)
                hn::Store(hn::IfThenElse(alive.part[k], z, stored), d, block.value + k * lanes32);
        }
        if (update) group.one_depth = std::uint16_t(group.one_depth & ~(1u << i));
        return alive;
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
