// The bytes of a stream around its parts: an identifier, and before each part its size and digest.
// A size of 0 is the end, with the number of parts in place of the digest. Little-endian.
#pragma once

#include "gw/planes.h"

#include <cstdint>
#include <string_view>

namespace gw::inspect {

/// Version 1; the letters are where FlatBuffers has its file identifier.
inline constexpr std::string_view stream_identifier{"\1\0\0\0GWTS", 8};

struct PartHead {
    std::uint64_t size = 0;  ///< of the part in bytes
    Digest digest;           ///< XXH3-128 of the part
};

}  // namespace gw::inspect
