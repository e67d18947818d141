// Values that all pixels of a block share, stored instead of its pixels. Does not say how blocks
// become uniform: gw/fast/uniform/uniform-inl.h.
#pragma once

#include "gw/base/types.h"
#include "gw/fast/frame/tile_plane.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gw::fast {

/// Blocks come in groups of 4x4: a vector holds one value of each block of a group.
inline constexpr int group_blocks = 4;

/// The common value of each of 16 blocks, an element or a bit each: block 4 (y mod 4) + x mod 4.
/// If a block's bit is set, its value is stored only here. The block's pixels in the plane have no
/// meaning until write_back_blocks() writes them.
struct alignas(64) UniformGroup {
    std::uint64_t color[16] = {};  ///< bits of an Rgba
    std::uint32_t depth[16] = {};  ///< the one depth, or an index into the tile's DepthPlanes
    std::uint16_t one_color = 0;
    std::uint16_t one_depth = 0;  ///< all pixels have one depth
    /// the depths are those of one plane, as hardware compresses them
    std::uint16_t one_plane = 0;

    Rgba color_of(std::uint32_t block) const { return std::bit_cast<Rgba>(color[block]); }
};

/// The depth planes of a tile's blocks. Their values at these blocks are below 2^32 without
/// wrapping.
using DepthPlanes = std::vector<TilePlane>;
inline constexpr std::size_t max_depth_planes = 256;

/// The planes of a tile that have uniform blocks.
struct UniformPlanes {
    bool color = false, depth = false;
};

}  // namespace gw::fast
