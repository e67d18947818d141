// From an ID buffer's colours to identifiers [F2.2], and which of them are there. Does not draw or scan.
#pragma once

#include <cstdint>
#include <span>

namespace gw::radiosity {

/// scene::id_of() of each packed colour into `ids`, which has room for all; seen[id] becomes 1 for every
/// identifier that is there.
void identify(std::span<const std::uint32_t> colors, std::uint32_t* ids, char* seen);

}  // namespace gw::radiosity
