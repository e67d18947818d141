// Which identifiers an ID buffer [F2.2] has. Does not draw or scan.
#pragma once

#include <cstdint>
#include <span>

namespace gw::radiosity {

/// present[id] becomes 1 for the identifier, the low 24 bits, of every packed colour; `row` of them
/// are a row.
void mark_present_ids(std::span<const std::uint32_t> pixels, std::size_t row, char* present);

}  // namespace gw::radiosity
