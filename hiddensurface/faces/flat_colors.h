// A colour for each polygon of a hidden-surface picture. Does not draw.
#pragma once

#include "hiddensurface/interface/algorithm.h"

#include <array>
#include <map>

namespace gw::hiddensurface {

/// Three channels of 8 bits.
using FlatColor = std::array<std::uint16_t, 3>;

/// A colour for each identifier: its material's Kd, darker the more the polygon is turned from the
/// eye. If Kd is black, Ke, Ka or Ks takes its place. A polygon without a material has a colour of
/// its own. 0 is the background.
std::map<std::uint32_t, FlatColor> flat_colors(const Input& input);

/// "#ff0000"
std::string hex_of(const FlatColor& color);
/// The same colours as a log's header has them.
std::map<std::uint32_t, std::string> hex_colors(const Input& input);

}  // namespace gw::hiddensurface
