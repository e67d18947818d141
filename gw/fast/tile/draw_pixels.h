// Draws a rectangle of pixels in a tile, behind run-time dispatch.
#pragma once

#include "gw/fast/frame/box.h"
#include "gw/fast/plan/tile_draw.h"

namespace gw {

class PlacedPixels;
struct Resolved;

namespace fast {

/// A rectangle of colours or depths, and its part inside one tile, which is not empty.
struct PixelsDraw {
    const PlacedPixels* placed = nullptr;
    const Resolved* state = nullptr;
    Tile tile;
    BlockBox box;
    OpCounts* counts = nullptr;
    int sample = 0;  ///< of a surface with samples
};
void draw_pixels(const PixelsDraw& draw);

}  // namespace fast
}  // namespace gw
