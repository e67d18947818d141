// Clears a tile's colours and depths, and writes uniform blocks to the planes, behind run-time
// dispatch. Does not clear stencil or accumulation.
#pragma once

#include "gw/fast/frame/box.h"

#include <array>
#include <cstdint>

namespace gw::fast {

/// Colours and depths of a tile that a Clear sets: those inside the box, which is not empty.
struct ClearBlocks {
    Tile tile;
    BlockBox box;
    Rgba written_bits{};        ///< of the colour's channels
    bool clears_color = false;  ///< all of them
    bool clears_depth = false;
    Rgba color{};
    std::uint32_t depth = 0;

    bool touches_color() const { return written_bits != Rgba{}; }
};
void clear_blocks(const ClearBlocks& clear);

/// Writes the values of uniform blocks to these planes, for code that does not know uniform blocks.
void write_back_blocks(const Tile& tile, UniformPlanes which = {true, true});

}  // namespace gw::fast
