// Reading a tile's colours back, behind run-time dispatch. Does not know passes or counts.
#pragma once

#include "gw/fast/frame/box.h"

#include <cstdint>

namespace gw::fast {

/// Colours of a tile that a Read wants: those inside the box, which is not empty.
struct ReadColors {
    Tile tile;
    BlockBox box;
    Rect rect;                        ///< of the command
    Rgba* out = nullptr;              ///< its pixels, rows from the bottom
    std::uint32_t* packed = nullptr;  ///< the same as words; not null: these are written instead
};
void read_colors(const ReadColors& read);

}  // namespace gw::fast
