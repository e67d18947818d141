// Positions that are the same point: bit-equal ones, and 0 and -0 alike. Has no tolerance.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <vector>

namespace gw::scene {

/// For each position the index of the first one equal to it.
std::vector<std::uint32_t> weld(const std::vector<vec3>& positions);
std::vector<std::uint32_t> weld(const std::vector<dvec3>& positions);

}  // namespace gw::scene
