// Some triangles of a part, for passes that do not draw all of it. Does not choose them.
#pragma once

#include "multipass/frame/placed_model.h"

#include <cstdint>
#include <span>

namespace gw::multipass {

/// These triangles of the part's meshes, in this order.
Portion portion_of(const Stage& stage, std::size_t part, std::span<const std::uint32_t> triangles);

}  // namespace gw::multipass
