// One draw in one tile: the argument of every kernel, and the counts that the kernel adds to.
// Does not plan.
#pragma once

#include "gw/fast/frame/box.h"

#include <cstdint>
#include <span>

namespace gw {

struct Profile;

namespace fast {

struct BatchScratch;
struct DrawOp;
class RepeatedTexels;

/// Fragments of one operation by fate, or its pixels; summed over tiles.
struct OpCounts {
    std::uint64_t fragments = 0, alpha_killed = 0, stencil_killed = 0, depth_killed = 0,
                  written = 0;
    std::uint64_t pixels = 0, accum_overflows = 0;

    OpCounts& operator+=(const OpCounts& o) {
        fragments += o.fragments;
        alpha_killed += o.alpha_killed;
        stencil_killed += o.stencil_killed;
        depth_killed += o.depth_killed;
        written += o.written;
        pixels += o.pixels;
        accum_overflows += o.accum_overflows;
        return *this;
    }
};

struct TileDraw {
    const DrawOp* op = nullptr;
    const Profile* profile = nullptr;
    Tile tile;
    BlockBox box;
    OpCounts* counts = nullptr;
    BatchScratch* scratch = nullptr;
    RepeatedTexels* repeated = nullptr;
    std::span<const Tile> samples{};  ///< the tile of each sample; none without samples
};

}  // namespace fast
}  // namespace gw
