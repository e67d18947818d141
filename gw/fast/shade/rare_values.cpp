// Secondary colours, and fog from given coordinates, lane by lane. docs/manual/lighting.md, "Colour
// sum"; docs/manual/fog.md. Scalar twins: gw/reference/interpolants.cpp, shade.cpp. Does not add or
// blend them.
#include "gw/fast/raster/primitive.h"

#include "gw/base/arithmetic.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/stages/fog.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gw::fast {
namespace {

std::uint16_t secondary_at(const RarePlanes& p, std::size_t c, int i, int j, float w, int bits) {
    const std::int32_t v = value_of(p.secondary[c], i, j);
    if (!p.perspective) return static_cast<std::uint16_t>(v);
    const float nearest = std::nearbyint((static_cast<float>(v) * w) * float(max_of_bits(bits)));
    return static_cast<std::uint16_t>(
        std::clamp(static_cast<int>(nearest), int{p.low[c]}, int{p.high[c]}));
}

}  // namespace

void find_rare_values(const RarePlanes& p, const TileDraw& draw, int bx, int by, std::uint32_t mask,
                      ColorBlock& secondary, std::uint32_t* fog_factor) {
    const DrawOp& op = *draw.op;
    const int bits = op.state.bits;
    for (; mask != 0; mask &= mask - 1) {
        const int lane = std::countr_zero(mask);
        const int i = bx * block_side + lane % block_side, j = by * block_side + lane / block_side;
        const float w = 1.0f / static_cast<float>(value_of(p.q, i, j));
        if (op.sums_colors)
            for (std::size_t c = 0; c < 3; ++c)
                secondary.channel[c][lane] = secondary_at(p, c, i, j, w, bits);
        if (op.direct_fog)
            fog_factor[lane] = direct_fog_factor(op.state.state.fog, p.fog_offset,
                                                 static_cast<float>(value_of(p.fog, i, j)) * w,
                                                 p.fog_exponent, bits);
    }
}

}  // namespace gw::fast
