// Fragments of antialiased primitives in a tile: the stages with alpha multiplied by the coverage.
// docs/manual/rasterization.md, "Antialiasing"; scalar twin: gw/reference/smooth.cpp. Does not find
// the coverage. Included once per Highway target.
#if defined(GW_FAST_SMOOTH_PAINTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_SMOOTH_PAINTER_INL_H_
#undef GW_FAST_SMOOTH_PAINTER_INL_H_
#else
#define GW_FAST_SMOOTH_PAINTER_INL_H_
#endif

#include "gw/fast/fragments/fragments-inl.h"
#include "gw/fast/fragments/outer_pixels-inl.h"
#include "gw/fast/raster/shape_coverage.h"
#include "gw/fast/shade/batch-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Multiplies the alpha of a block by its coverage.
HWY_INLINE void cover_alpha(const TileDraw& draw, const CoverageBlock& coverage,
                            std::uint16_t* alpha) {
    const int bits = draw.profile->coverage_bits;
    if (bits == 8 && draw.op->state.bits == 8) {
        const D16 d;
        for (std::size_t i = 0; i < block_pixels; i += lanes16)
            hn::Store(mul_bytes(d, hn::Load(d, alpha + i), hn::Load(d, coverage.lane + i)), d,
                      alpha + i);
        return;
    }
    for (std::size_t i = 0; i < block_pixels; ++i)
        alpha[i] = covered_alpha(alpha[i], coverage.lane[i], bits);
}

/// Primitive i of a batch, in the pixels that have its values.
class SmoothPainter {
public:
    SmoothPainter(BatchPlanes& planes, std::size_t i, const PrimitiveFrame& frame, OpCounts& counts)
        : planes_(planes),
          draw_(planes.draw),
          i_(i),
          primitive_(*planes.corners.primitive[i]),
          frame_(frame),
          counts_(counts),
          depth_(depth_plane(draw_, primitive_, frame_)) {}

    /// Paints lanes of a block whose centres are inside the primitive, then those outside.
    void paint(int bx, int by, const CoverageBlock& coverage, std::uint32_t inside,
               std::uint32_t outside) {
        if (inside != 0)
            run(depth_, bx, by, coverage, inside,
                [&]() -> const ColorBlock& { return planes_.color_of(i_, bx, by, inside); });
        for (; outside != 0; outside &= outside - 1)
            paint_outside(bx, by, coverage, std::countr_zero(outside));
    }

private:
    void run(const DepthPlane& plane, int bx, int by, const CoverageBlock& coverage,
             std::uint32_t mask, const auto& color) {
        DepthBlock depth;
        shade_depth(plane, max_of_bits(draw_.profile->depth_bits), bx, by, depth);
        run_fragments(draw_.op->state, primitive_.front != 0, depth, draw_.tile,
                      draw_.tile.block(bx, by), mask, counts_, [&]() -> const ColorBlock& {
                          covered_ = color();
                          cover_alpha(draw_, coverage, covered_.channel[3]);
                          return covered_;
                      });
    }

    void paint_outside(int bx, int by, const CoverageBlock& coverage, int lane) {
        const PrimitiveFrame at = outer_frame(draw_, frame_, bx, by, lane);
        const std::uint32_t mask = 1u << lane;
        run(depth_plane(draw_, primitive_, at), bx, by, coverage, mask, [&]() -> const ColorBlock& {
            if (!OuterPixels<OuterCenters>::applies_to(planes_, i_))
                return outer_color(draw_, primitive_, at, bx, by, mask, outer_);
            if (!pixels_) pixels_.emplace(planes_, i_, planes_.corners.ordinal[i_]);
            pixels_->put(bx, by, mask, outer_);
            return shaded(draw_, outer_.texels[0], outer_);
        });
    }

    BatchPlanes& planes_;
    const TileDraw& draw_;
    std::size_t i_;
    const SetupPrimitive& primitive_;
    const PrimitiveFrame& frame_;
    OpCounts& counts_;
    const DepthPlane depth_;
    ColorBlock covered_;
    ShadeInputs outer_;
    std::optional<OuterPixels<OuterCenters>> pixels_;  ///< made for the first one
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
