// The planes of a machine as the host sees them. docs/manual.md, "Planes".
// Does not draw. Row 0 is the bottom row of the window (GL's origin); pixel (x, y) is at y * width
// + x.
#pragma once

#include "gw/base/types.h"
#include "gw/command_list.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gw {

struct Planes {
    int width = 0, height = 0;
    std::vector<Rgba> color;            ///< 0 .. 2^color_bits - 1
    std::vector<std::uint32_t> depth;   ///< 0 nearest .. 2^depth_bits - 1 farthest
    std::vector<std::uint8_t> stencil;  ///< 0 .. 2^stencil_bits - 1
    /// units of the frame buffer, wrapped to accum_bits
    std::vector<std::array<std::int32_t, 4>> accum;

    Planes() = default;
    /// All zero, depth too: a machine's planes are undefined before Clear, and here that is 0.
    Planes(int width, int height);
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width) + std::size_t(x);
    }
    bool operator==(const Planes&) const = default;
};

/// XXH3-128 of a plane: over the XXH3-128 digests of its 64x64 blocks, rows of blocks from the
/// bottom.
struct Digest {
    std::uint64_t high = 0, low = 0;
    auto operator<=>(const Digest&) const = default;
};

Digest digest(const Planes& planes, Plane plane);
/// 32 lower-case hexadecimal digits.
std::string to_string(const Digest& digest);

}  // namespace gw
