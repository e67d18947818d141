// What blocks have in common all over, kept instead of their pixels. Does not know how it comes
// about: gw/fast/uniform/uniform-inl.h.
#pragma once

#include "gw/base/types.h"
#include "gw/fast/frame/tile_plane.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gw::fast {

/// Blocks come in groups of 4x4: a vector holds what a group's blocks have.
inline constexpr int group_blocks = 4;

/// What all pixels of a block have, for 16 blocks, a bit or an element each: block 4 (y mod 4) + x
/// mod 4.
/// Where a block's bit is set, this stands here alone, and what the plane holds of the block has no
/// meaning until settle_blocks() writes it.
struct alignas(64) UniformGroup {
    std::uint64_t color[16] = {};  ///< bits of an Rgba
    std::uint32_t depth[16] = {};  ///< the one depth, or which of the tile's held planes
    std::uint16_t one_color = 0;
    std::uint16_t one_depth = 0;  ///< all pixels have one depth,
    /// or those of the triangle that covers them, as hardware compresses depths
    std::uint16_t one_plane = 0;

    Rgba color_of(std::uint32_t block) const { return std::bit_cast<Rgba>(color[block]); }
};

/// Planes of depths that a tile's blocks hold; values at these blocks are below 2^32 without
/// wrapping.
using HeldPlanes = std::vector<TilePlane>;
inline constexpr std::size_t max_held_planes = 256;

/// Planes of a tile of which some block's value stands in its UniformGroup.
struct UniformPlanes {
    bool color = false, depth = false;
};

}  // namespace gw::fast
