// A primitive at one place of a pixel whose centre it does not cover: at the centre (R9.28), or at a
// sample (R17.8). Does not evaluate planes.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/raster/setup.h"
#include "gw/stages/raster/samples.h"

#include <cstdint>

namespace gw::fast {

/// A primitive's frame at the centre of one pixel: planes are constant there.
inline PrimitiveFrame center_frame(const TileDraw& draw, const PrimitiveFrame& frame, int bx,
                                   int by, int lane) {
    const auto center = [&](int pixel) {
        return (std::int64_t{pixel} << frame.s) + (std::int64_t{1} << (frame.s - 1));
    };
    PrimitiveFrame at = frame;
    at.at_place = true;
    at.place_x = center(draw.tile.x + bx * block_side + lane % block_side);
    at.place_y = center(draw.tile.y + by * block_side + lane / block_side);
    return at;
}

/// At one pixel whose centre is an outer one: planes are limited, too.
inline PrimitiveFrame outer_frame(const TileDraw& draw, const PrimitiveFrame& frame, int bx, int by,
                                  int lane) {
    PrimitiveFrame at = center_frame(draw, frame, bx, by, lane);
    at.outer = true;
    return at;
}

/// At sample k of one pixel, which the primitive covers.
inline PrimitiveFrame frame_at_sample(const TileDraw& draw, const PrimitiveFrame& frame, int k,
                                      int bx, int by, int lane) {
    const JitterState shift = sample_shift(draw.op->state.samples, k, frame.s);
    PrimitiveFrame at = center_frame(draw, frame, bx, by, lane);
    at.place_x -= shift.x;
    at.place_y -= shift.y;
    return at;
}

}  // namespace gw::fast
