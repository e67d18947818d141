// Draws a bin of primitives in a tile, and fragments made by the host, behind run-time dispatch.
// Does not plan or bin.
#pragma once

#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/tile_draw.h"

#include <cstdint>
#include <span>

namespace gw::fast {

/// Draws the primitives of `bin` in order.
void draw_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin);

/// Fragments of one block (mask: a bit per lane).
struct BlockFragments {
    const Resolved* state = nullptr;
    std::size_t block = 0;
    std::uint32_t mask = 0;
    bool front = true;
    int sample = 0;  ///< of a surface with samples
};
/// Runs the host's fragments through the tests to the planes.
void process_fragments(const BlockFragments& fragments, const ColorBlock& color,
                       const DepthBlock& depth, const Tile& tile, OpCounts& counts);

}  // namespace gw::fast
