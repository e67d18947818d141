// From an ID buffer's colours to identifiers [F2.2], and which of them are there. Does not draw or scan.
#pragma once

#include "gw/types.h"

#include <cstdint>
#include <span>

namespace gw::radiosity {

/// scene::id_of() of each colour, 8 bits a channel; `ids` has room for all.
void identify(std::span<const Rgba> colors, std::uint32_t* ids);

/// Sets seen[id] to 1 for every identifier that is there.
void mark_seen(std::span<const std::uint32_t> ids, char* seen);

}  // namespace gw::radiosity
