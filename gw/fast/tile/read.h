// Reads a tile's colours back, behind run-time dispatch. Does not know passes or counts.
#pragma once

#include "gw/fast/frame/box.h"
#include "gw/machine.h"

#include <cstdint>

namespace gw::fast {

/// The part of a Read that one tile provides: colours inside the box, which is not empty.
struct ReadColors {
    Tile tile;
    BlockBox box;
    Rect rect;                        ///< of the command
    Rgba* out = nullptr;              ///< its pixels, rows from the bottom
    std::uint32_t* packed = nullptr;  ///< if not null, packed words are written here instead
    ReadLayout layout{};              ///< of the packed words
};
void read_colors(const ReadColors& read);

}  // namespace gw::fast
