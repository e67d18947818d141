// Channels of 16 bits rounded to bytes, in a loop that compilers make vectors of.
// docs/manual/numbers.md.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gw {

/// rescale(v, 16, 8) of each value: (v + 128) / 257. `to` has as many bytes. From 65407 on, values
/// become 255; they are 65407 here, so that no sum leaves 16 bits.
inline void rescale_to_bytes(std::span<const std::uint16_t> values, std::uint8_t* to) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto v = std::uint16_t(std::min(values[i], std::uint16_t{65407}) + 128);
        to[i] = std::uint8_t(std::uint16_t(v - (v >> 8)) >> 8);
    }
}

}  // namespace gw
