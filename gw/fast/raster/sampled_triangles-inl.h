// Triangles of a tile at each sample of its pixels. docs/manual/samples.md; scalar twin:
// gw/reference/primitives.cpp. Does not test or paint. Included once per Highway target.
#if defined(GW_FAST_SAMPLED_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SAMPLED_TRIANGLES_INL_H_
#undef GW_FAST_SAMPLED_TRIANGLES_INL_H_
#else
#define GW_FAST_SAMPLED_TRIANGLES_INL_H_
#endif

#include "gw/fast/raster/cover-inl.h"
#include "gw/stages/raster/samples.h"

#include <algorithm>
#include <array>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The frame of a primitive at sample k.
HWY_INLINE PrimitiveFrame sample_frame(const TileDraw& draw, const SetupPrimitive& primitive,
                                       int samples, int k) {
    const JitterState shift = sample_shift(samples, k, draw.profile->subpixel_bits),
                      &jitter = draw.op->state.state.jitter;
    PrimitiveFrame frame =
        primitive_frame(*draw.op->set, primitive, {jitter.x + shift.x, jitter.y + shift.y},
                        draw.profile->subpixel_bits, draw.tile);
    if (primitive.kind == MeshKind::Points) frame.point_size = point_size_of(draw, primitive);
    return frame;
}

/// Triangles at the centres of pixels, without depths, and at each sample.
struct SampledTriangles {
    Triangles center;
    std::array<Triangles, max_samples> at;
    int samples;

    HWY_INLINE SampledTriangles(const TileDraw& draw, std::span<const std::uint32_t> bin, int n)
        : samples(n) {
        set_up_triangles(draw, bin, false, center);
        for (int k = 0; k < n; ++k)
            set_up_triangles(draw, bin, needs_depth(*draw.op), at[std::size_t(k)],
                             sample_shift(n, k, draw.profile->subpixel_bits));
    }
    /// Those at samples and the one at the centre, of triangle i, that may have pixels.
    void for_each_of(std::size_t i, const auto& visit) const {
        for (int k = 0; k < samples; ++k)
            if (!at[std::size_t(k)].empty(i)) visit(k, at[std::size_t(k)]);
    }
    HWY_INLINE bool is_small(std::size_t i) const {
        bool small = center.empty(i) || center.is_small(i);
        for_each_of(i, [&](int, const Triangles& t) { small = small && t.is_small(i); });
        return small;
    }
    /// The blocks that triangle i may touch with a sample; none: x0 > x1.
    HWY_INLINE BlockRange range(std::size_t i) const {
        BlockRange out{INT32_MAX, INT32_MAX, -1, -1};
        for_each_of(i, [&](int, const Triangles& t) {
            const BlockRange r = BlockRange::of(t, i);
            out = {std::min(out.x0, r.x0), std::min(out.y0, r.y0), std::max(out.x1, r.x1),
                   std::max(out.y1, r.y1)};
        });
        return out;
    }
};

/// The 4x4 blocks from (x, y) on of a triangle at the centres of pixels or at a sample.
struct SampledGroup {
    EdgeWalk edge;
    SquareEdges squares;
    Extents extents;

    HWY_INLINE void find(const TileEdges& edges, int x, int y) {
        edge.aim(edges);
        extents = extents_of(edges, x * block_side, y * block_side, block_side, squares);
    }
    HWY_INLINE std::uint32_t covered(int block) const {
        if (extents.outside >> block & 1) return 0;
        if (extents.inside >> block & 1) return all_lanes;
        return edge.covered(squares, std::size_t(block)).bits();
    }
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
