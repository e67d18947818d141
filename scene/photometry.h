// Numbers of light: luminous intensities in candela by direction, as one number or as an IES file's
// distribution, and the weights by which colours count. One world unit is a metre. Does not read
// files (read_ies.h) and does not shade.
#pragma once

#include "gw/base/types.h"

#include <memory>
#include <string>
#include <vector>

namespace gw::scene {

struct Light;

/// The part of a colour that counts as light: Y of sRGB's primaries. 1 for white.
double luminance_of(const dvec3& color);
/// The colour with luminance 1. Precondition: it is not 0.
dvec3 with_luminance_1(const dvec3& color);

/// A distribution by two angles [LM-63], whose 0, 0 is straight down. Degrees, ascending.
struct Photometry {
    enum class Type {
        C,  ///< vertical angles from straight down, horizontal ones about the vertical axis
        B,  ///< vertical angles about the axis of width, horizontal ones from the middle towards it
    } type = Type::C;
    std::vector<double> vertical, horizontal;
    std::vector<double>
        candela;       ///< all vertical angles of the first horizontal one, then of the next
    std::string name;  ///< the file's, for messages

    /// Bilinear between the angles; 0 beyond them. Those that the file leaves out follow by symmetry.
    double at(double vertical_angle, double horizontal_angle) const;
    /// The luminous flux: the integral over all directions, of what `at` gives.
    double lumen() const;
};

/// The luminous intensity of a light, which has no area.
struct Luminous {
    dvec3 candela{0};  ///< of a point; along the axis of a spot; the factor of a distribution
    std::shared_ptr<const Photometry> web;  ///< null: all directions alike, or the spot's exponent
    double turn = 0;                        ///< of the distribution about its axis, degrees
};

/// In candela, by channel, towards a unit direction from the light; 0 if it has no numbers of light.
/// A distribution's straight down is the light's direction. If that is -y, horizontal angles 0 and
/// 90 of type C are +x and -z; vertical angle 90 of type B is +x, horizontal angle 90 is +z. Else all
/// are turned the shortest way.
dvec3 intensity(const Light& light, const dvec3& direction);
/// In lumen, by channel: the integral of `intensity`.
dvec3 luminous_flux(const Light& light);

}  // namespace gw::scene
