// An integer plane, relative to a tile. docs/manual.md, "Planes": closed form modulo 2^64.
#pragma once

#include <cstdint>

namespace gw::fast {

/// V at pixel (i, j) of the tile is ((c + gx i + gy j) mod 2^64) >> 16, in as many bits as the
/// value has.
struct TilePlane {
    std::uint64_t c = 0;
    std::int64_t gx = 0, gy = 0;
    bool sliver = false;  ///< the gradients are wrapped: the exact ones need more than 62 bits
    bool operator==(const TilePlane&) const = default;
};

/// V of at most 32 bits.
inline std::int32_t value_of(const TilePlane& p, int i, int j) {
    const std::uint64_t v =
        p.c + std::uint64_t(p.gx) * std::uint64_t(i) + std::uint64_t(p.gy) * std::uint64_t(j);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(v >> 16));
}

/// A primitive's depths: a plane, and the polygon offset that is added to its values.
struct DepthPlane {
    TilePlane plane;
    std::int64_t offset = 0;
};

}  // namespace gw::fast
