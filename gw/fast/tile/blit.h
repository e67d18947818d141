// Copies a tile's planes to the tile at the same place of another surface, behind run-time dispatch.
// Does not move pixels. [R16.7], [R17.6]
#pragma once

#include "gw/fast/frame/box.h"
#include "gw/planes.h"

#include <span>

namespace gw::fast {

/// The part of a Blit that one tile gets: the pixels inside the box, which is not empty. Of as many
/// samples, each goes to the same one; of one, it goes to all; to one, the mean of all colours, and the
/// depth and stencil value of the first.
struct BlitBlocks {
    std::span<const Tile> from, to;  ///< of each sample
    BlockBox box;
    PlaneMask planes = 0;  ///< of Color, Depth and Stencil
};
void blit_blocks(const BlitBlocks& blit);

}  // namespace gw::fast
