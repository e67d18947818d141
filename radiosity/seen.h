// Which identifiers an ID buffer [F2.2] has. Does not draw or scan.
#pragma once

#include <cstdint>
#include <span>

namespace gw::radiosity {

/// seen[id] becomes 1 for the identifier, the low 24 bits, of every packed colour.
void mark_seen(std::span<const std::uint32_t> pixels, char* seen);

}  // namespace gw::radiosity
