// A whole file as bytes, after a check of its size and its beginning. Does not interpret them
// further.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gw::inspect {

/// The required beginning of a file, and the message if it differs: "not a recording; expected
/// ...".
struct Beginning {
    std::function<bool(std::string_view)> fits;  ///< of the first bytes, at most 4096
    const char* otherwise = "";
};

/// The first bytes, at most 4096, of a file of any size. Else throws Error as read_bytes does.
std::string first_bytes(const std::filesystem::path& file);

/// Throws Error naming the file if it is missing, larger than 2 GB, begins otherwise or cannot be
/// read, and if it is no regular file: a pipe may never end. A refused file is not read any
/// further.
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file, const Beginning& beginning);

/// FlatBuffers' file identifier, in bytes 4 to 7.
bool has_identifier(std::string_view bytes, std::string_view identifier);

}  // namespace gw::inspect
