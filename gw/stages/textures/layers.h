// Look-ups with r at a pixel: textures of three dimensions, cubes, depths. docs/manual/texture.md,
// "Textures with r". Does not interpolate coordinates: each machine does.
#pragma once

#include "gw/stages/perspective.h"
#include "gw/stages/resolve.h"
#include "gw/stages/texels.h"

#include <array>
#include <cmath>
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

/// Of each face of a cube: the coordinate that is largest, and those that s and t follow, with
/// signs. [GL 1.5] table 3.19.
struct FaceRule {
    int major, s, t;
    bool s_is_negative, t_is_negative;
};
inline constexpr std::array<FaceRule, 6> face_rules{{{0, 2, 1, true, true},
                                                     {0, 2, 1, false, true},
                                                     {1, 0, 2, false, false},
                                                     {1, 0, 2, false, true},
                                                     {2, 0, 1, false, true},
                                                     {2, 0, 1, true, true}}};

/// The face of a direction x, y, z.
inline int face_of(double dx, double dy, double dz) {
    const double x = std::abs(dx), y = std::abs(dy), z = std::abs(dz);
    if (x >= y && x >= z) return dx < 0 ? 1 : 0;
    if (y >= z) return dy < 0 ? 3 : 2;
    return dz < 0 ? 5 : 4;
}

/// A face and its coordinates, 0 .. 1.
struct FacePoint {
    int face = 0;
    double s = 0.5, t = 0.5;
};
FacePoint face_point(const dvec3& direction);
/// The texel that a linear filter sees at (i, j) of a face, at most one texel beyond its edges.
Rgba face_texel(const Texels& texels, const TexelLevel& level, bool seamless, int face, int i,
                int j);

/// The texture's value at a pixel, in texels of textures with_r.
Rgba texel_with_r(const Texels& texels, const TextureState& state, const ResolvedTexture& resolved,
                  const PixelCoordinates& at);
/// The same at (s, t, r) / q of a rectangle of pixels: the filter magnifies.
Rgba texel_in_place(const Texels& texels, const TextureState& state,
                    const ResolvedTexture& resolved, const vec4& strq);

}  // namespace gw
