// Look-ups with r at a pixel: textures of three dimensions, cubes, depths. docs/manual/texture.md,
// "Textures with r". Does not interpolate coordinates: each machine does.
#pragma once

#include "gw/stages/perspective.h"
#include "gw/stages/resolve.h"
#include "gw/stages/texels.h"

#include <array>
#include <cstdint>

namespace gw {

/// One of s, t, r at a pixel: u 2^exponent / q.
struct PixelCoordinate {
    std::int64_t u = 0;
    int exponent = 0;
    PlaneSlope slope;  ///< of its numerator
};
struct PixelCoordinates {
    std::array<PixelCoordinate, 3> at;
    std::int64_t q = 1;
    PlaneSlope q_slope;
    int dx = 0, dy = 0;  ///< the pixel, from the one that slopes are given at
};

/// The face of a cube and its coordinates, 0 .. 1. [GL 1.5] table 3.19.
struct FacePoint {
    int face = 0;
    double s = 0.5, t = 0.5;
};
FacePoint face_point(const dvec3& direction);

/// The texture's value at a pixel, in texels of textures with_r.
Rgba texel_with_r(const Texels& texels, const TextureState& state, const ResolvedTexture& resolved,
                  const PixelCoordinates& at);
/// The same at (s, t, r) / q of a rectangle of pixels: the filter magnifies.
Rgba texel_in_place(const Texels& texels, const TextureState& state,
                    const ResolvedTexture& resolved, const vec4& strq);

}  // namespace gw
