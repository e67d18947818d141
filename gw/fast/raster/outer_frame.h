// A primitive at one pixel outside it (R9.28). Does not evaluate planes.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/raster/setup.h"

#include <cstdint>

namespace gw::fast {

/// A primitive's frame at one pixel whose centre is an outer one: planes are constant there.
inline PrimitiveFrame outer_frame(const TileDraw& draw, const PrimitiveFrame& frame, int bx, int by,
                                  int lane) {
    const auto center = [&](int pixel) {
        return (std::int64_t{pixel} << frame.s) + (std::int64_t{1} << (frame.s - 1));
    };
    PrimitiveFrame at = frame;
    at.limited = true;
    at.pixel_x = center(draw.tile.x + bx * block_side + lane % block_side);
    at.pixel_y = center(draw.tile.y + by * block_side + lane / block_side);
    return at;
}

}  // namespace gw::fast
