// RGBM: colours beyond white in four channels of 8 bits, for engines without floating-point textures.
// A texel means R, G, B times A times a range. Linear: not encoded for a display. Does not write files.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstdint>

namespace gw::image {

/// The smallest A with which no channel exceeds 1, then R, G, B to nearest. A colour of 0 to `range` in
/// each channel comes back within (its largest channel + range / 255) / 510. Others are clamped.
/// Precondition: range above 0.
std::array<std::uint8_t, 4> rgbm_of(const dvec3& color, double range);
dvec3 color_of_rgbm(const std::array<std::uint8_t, 4>& rgbm, double range);

}  // namespace gw::image
