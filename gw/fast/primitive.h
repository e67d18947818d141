// One primitive's planes in a tile, as one draw wants them. docs/manual.md, "Planes", "Perspective".
// Does not evaluate planes over blocks: the kernels do.
#pragma once

#include "gw/fast/kernels.h"
#include "gw/fast/setup.h"
#include "gw/perspective.h"

namespace gw::fast {

/// A texture coordinate: numerator plane, the factor to 1/256 texels of level 0, and what Clamp adds back.
struct TexturePlane {
    TilePlane plane;
    float scale = 1;
    std::int32_t offset = 0;
    int exponent = 0;
    double k = 0;
    CoordinateSlope slope;
};

struct PrimitivePlanes {
    bool front = true;
    TilePlane depth;
    std::int64_t depth_offset = 0;
    TilePlane color[4];  ///< numerators where perspective_color
    bool perspective_color = false;
    std::uint32_t color_low[4] = {}, color_high[4] = {};
    TilePlane q;    ///< denominator
    TilePlane fog;  ///< factor, or numerator of the coordinate
    float fog_scale = 1;
    TilePlane texture_q;  ///< where it differs from q
    bool projective = false;
    bool texture_by_pixel = false;  ///< a level of detail, a projection or a comparison: pixel by pixel
    TexturePlane s, t, r;
    int slope_x = 0, slope_y = 0;  ///< window pixel that the slopes are given at
};

/// Fills what the draw needs.
void make_planes(const TileDraw& draw, const SetupPrimitive& primitive, const PrimitiveFrame& frame,
                 PrimitivePlanes& out);

/// Lanes of `mask` in block (bx, by), one by one: every filter, projective coordinates, shadow comparison.
void sample_by_pixel(const PrimitivePlanes& planes, const TileDraw& draw, int bx, int by, std::uint32_t mask,
                     ColorBlock& out);

}  // namespace gw::fast
