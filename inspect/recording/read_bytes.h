// A whole file, or what comes out of a pipe, as bytes. Does not interpret them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace gw::inspect {

/// Throws Error naming the file where it is missing, a folder, a device, larger than 2 GB or cannot
/// be read.
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file);

}  // namespace gw::inspect
