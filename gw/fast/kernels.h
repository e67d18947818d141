// The vector kernels, behind run-time dispatch: one entry for drawing, one for fragments that the
// host made.
// Does not plan. Every target computes the same bits: docs/manual.md is the scalar twin of each
// line.
#pragma once

#include "gw/fast/frame/box.h"
#include "gw/fast/plan/plan.h"
#include "gw/fast/tile/tile_run.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gw::fast {

struct BatchRoom;
class RepeatedTexels;

/// One draw in one tile.
struct TileDraw {
    const DrawOp* op = nullptr;
    const Profile* profile = nullptr;
    Tile tile;
    BlockBox box;
    OpCounts* counts = nullptr;
    BatchRoom* room = nullptr;
    RepeatedTexels* repeated = nullptr;
};

struct Coverage;

/// Draws the primitives of `bin` in order.
void draw_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin);

/// Draws a depth pass and keeps in a record what may be visible.
void draw_recording(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record);
/// Makes the record of a draw under Equal: from a depth pass where there was one.
void record_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin, Coverage& record);
/// Draws from a record that is made.
void replay_primitives(const TileDraw& draw, Coverage& record);

/// Sends fragments of one block (mask: bit per lane) through the tests to the planes.
struct BlockFragments {
    const Resolved* state = nullptr;
    std::size_t block = 0;
    std::uint32_t mask = 0;
    bool front = true;
};
void process_fragments(const BlockFragments& fragments, const ColorBlock& color,
                       const DepthBlock& depth, const Tile& tile, OpCounts& counts);

/// One accumulation command on the lanes of `mask` of a block; how many channels overflowed.
std::uint64_t accumulate_block(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                               ColorBlock& color, std::uint32_t mask);

/// Colours and depths of a tile that a Clear sets: those inside the box, not empty.
struct ClearBlocks {
    Tile tile;
    BlockBox box;
    std::array<bool, 4> channel{};  ///< which of the colour's
    bool clears_depth = false;
    Rgba color{};
    std::uint32_t depth = 0;

    bool clears_color() const { return channel == std::array{true, true, true, true}; }
};
void clear_blocks(const ClearBlocks& clear);

/// Writes the values of uniform blocks to these planes: for whatever does not know such blocks.
void settle_blocks(const Tile& tile, UniformPlanes which = {true, true});

/// Colours of a tile that a Read wants: those inside the box, not empty.
struct ReadColors {
    Tile tile;
    BlockBox box;
    Rect rect;                        ///< of the command
    Rgba* out = nullptr;              ///< its pixels, rows from the bottom
    std::uint32_t* packed = nullptr;  ///< the same as words, where they are wanted
};
void read_colors(const ReadColors& read);

/// The vector instruction set in use, in Highway's words, and all that this processor has.
std::string simd_target();
std::vector<std::string> simd_targets();
/// Uses only the named target from now on (tests); "" goes back to the best. False where there is
/// no such target.
bool use_simd_target(const std::string& name);

}  // namespace gw::fast
