// A drawable whose colours are indices: the map through which its window shows them. Recordings keep
// it. Does not show anything.
#pragma once

#include <cstdint>
#include <vector>

namespace gw::gl {

/// Index 0 of the last three shows what is below them.
enum class IndexPlanes : std::uint8_t { Window, Overlay, Underlay, PopUp };

struct ShownIndices {
    IndexPlanes planes = IndexPlanes::Window;
    int bits = 0;                        ///< of an index; 0: colours are not indices
    int bits_in_r = 8;                   ///< of an index, its lowest; the others are in G
    std::vector<std::uint32_t> entries;  ///< 2^bits of 8 bits a channel, R lowest
    bool operator==(const ShownIndices&) const = default;
};

}  // namespace gw::gl
