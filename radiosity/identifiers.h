// From an ID buffer's colours to identifiers [F2.2], and which of them are there. Does not draw or scan.
#pragma once

#include <cstdint>
#include <span>

namespace gw::radiosity {

/// Makes scene::id_of() of each packed colour; seen[id] becomes 1 for every identifier that is there.
void identify(std::span<std::uint32_t> pixels, char* seen);

}  // namespace gw::radiosity
