// Fog from given coordinates, lane by lane. docs/manual/fog.md. Scalar twins:
// gw/reference/interpolants.cpp, shade.cpp. Does not blend it.
#include "gw/fast/raster/primitive.h"

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/stages/fog.h"

#include <bit>

namespace gw::fast {

void find_given_fog(const GivenFog& fog, const TileDraw& draw, int bx, int by, std::uint32_t mask,
                    std::uint32_t* factor) {
    const Resolved& resolved = draw.op->state;
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        const int i = bx * block_side + lane % block_side, j = by * block_side + lane / block_side;
        const float w = 1.0f / static_cast<float>(value_of(fog.q, i, j));
        factor[lane] = direct_fog_factor(resolved.state.fog, fog.offset,
                                         static_cast<float>(value_of(fog.numerator, i, j)) * w,
                                         fog.exponent, resolved.bits);
    }
}

}  // namespace gw::fast
