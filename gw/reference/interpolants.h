// The values of a primitive at each of its pixels, as planes: depth, colour, fog, texture
// coordinates. docs/manual/rasterization.md, "Planes", "Perspective". Does not look up texels or
// test fragments.
#pragma once

#include "gw/reference/plane_equation.h"
#include "gw/stages/perspective.h"
#include "gw/stages/resolve.h"

#include <functional>
#include <span>

namespace gw::reference {

/// A primitive's corners after projection: 1, 2 or 3, in the order given.
struct Corner {
    WindowVertex window;
    dvec4 texcoord{0, 0, 0, 1};
    std::array<std::int64_t, 4> color{}, secondary{};
    double fog = 0;
    std::array<dvec4, max_texture_units - 1> more_texcoords{};

    const dvec4& texcoord_of(std::size_t unit) const {
        return unit == 0 ? texcoord : more_texcoords[unit - 1];
    }
};

/// Makes a plane from values at the corners, in their order: of a triangle, of a line, or constant.
using PlaneMaker = std::function<PlaneEquation(const std::array<std::int64_t, 3>&)>;

/// numerator / denominator at a pixel, times 2^exponent, plus the offset k.
struct PerspectiveValue {
    PlaneEquation plane;
    double offset = 0;
    int exponent = 0;
    CoordinateSlope slope;     ///< for rho
    PlaneSlope plane_slope{};  ///< the same, of textures with r

    float at(int x, int y, float w) const;  ///< U W, without exponent and offset
};

/// A colour's channels.
struct ColorPlanes {
    std::array<PlaneEquation, 4> plane;                  ///< screen-linear
    std::array<PlaneEquation, 4> numerator;              ///< perspective_color
    std::array<std::array<std::int64_t, 2>, 4> range{};  ///< least and largest corner value
};

/// The texture coordinates of a unit.
struct TextureValues {
    PlaneEquation q;  ///< denominator; differs from that of other values if they are projective
    PlaneSlope q_slope{};
    bool projective = false;
    PerspectiveValue s, t, r;
};

struct Interpolants {
    PlaneEquation depth;
    ColorPlanes color, secondary;
    bool perspective_color = false;
    PlaneEquation fog;                ///< factor (fog at the vertex)
    PerspectiveValue fog_coordinate;  ///< fragment fog
    PlaneEquation q;                  ///< denominator of all perspective values
    std::array<TextureValues, max_texture_units> textures;  ///< by unit
    int slope_x = 0, slope_y = 0;                           ///< the pixel that the slopes refer to
};

/// How a unit's texture coordinates are interpolated.
enum class TextureUse { None, Plain, Projective };
using TextureUses = std::array<TextureUse, max_texture_units>;

Interpolants interpolants(std::span<const Corner> corners, const PlaneMaker& plane,
                          const Resolved& state, const Profile& profile,
                          const TextureUses& textures);

/// Sets the texture coordinates of a point sprite of `size` pixels in a unit: s and t from 0 to 1, t
/// downwards, or 0.
void set_sprite(Interpolants& values, std::size_t unit, int size, bool without_t);

/// The same values at one pixel outside the primitive: each plane is limited to the values of its
/// corners.
Interpolants limited_to_pixel(Interpolants values, int x, int y);
/// The same values of the primitive after a move, in sub-pixels. Slopes stay.
Interpolants moved(Interpolants values, const JitterState& by);

/// 1 / Q: the one division of a pixel.
float reciprocal(const PlaneEquation& q, int x, int y);

/// An interpolated colour: the one before texture and fog, or the secondary one.
Rgba color_at(const Interpolants& values, const ColorPlanes& color, int x, int y, int bits);

}  // namespace gw::reference
