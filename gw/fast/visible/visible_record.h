// Visible fragments, computed once. After a depth prepass, a pass under Equal touches only pixels
// whose stored depth is a primitive's. These are the same for every pass of the same geometry. A
// record keeps every primitive that ties, not only one a pixel. record.cpp makes records, and
// replay.cpp draws from them; gw/fast/plan/share_visibility.cpp decides which draws share one.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/raster/primitive.h"
#include "gw/state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::fast {

struct FastTexels;
struct VertexTexcoords;

/// Pixels of one block at which a primitive's depth equals the stored one.
struct VisibleBlock {
    std::uint16_t block = 0, mask = 0;
    std::uint32_t primitive = 0;  ///< in VisibleRecord::primitives
};
/// The entries of one block: blocks[first .. first + count - 1].
struct BlockRun {
    std::uint16_t block = 0, mask = 0;  ///< lanes of all entries
    bool tied = false;                  ///< a lane has two primitives
    std::uint32_t first = 0, count = 0;
};

/// The texels of a record's blocks, kept while draws look up the same texture.
struct TextureCache {
    const VertexTexcoords* texcoords = nullptr;
    const FastTexels* texels = nullptr;
    TextureState state;                 ///< without the environment
    std::vector<TexturePlanes> planes;  ///< of the record's primitives
    std::vector<ColorBlock> found;      ///< of each run, all lanes
    std::vector<std::uint8_t> made;     ///< whether found[i] is made
};

/// One draw's record in one tile.
struct VisibleRecord {
    bool drawn = false;  ///< by the depth pass; `primitives` and `blocks` may be visible
    bool made = false;
    std::vector<std::uint32_t> primitives;  ///< ordinals in GeometrySet::primitives
    std::vector<TilePlane> depth;           ///< of `primitives`, until the record is made
    /// by block; in a block, in the order of the primitives
    std::vector<VisibleBlock> blocks;
    /// the number of fragments at each pixel, if a draw's stencil test needs it
    std::vector<DepthBlock> fragments;
    std::uint64_t total = 0;  ///< fragments of the draw, visible or not

    std::vector<BlockRun> runs;          ///< of `blocks`
    std::vector<VisibleBlock> by_block;  ///< scratch to sort `blocks`

    /// of `primitives`, a batch each; elements after the last batch are unused
    std::vector<Corners> corners;
    std::vector<NarrowBatch> narrow;  ///< the same, for the draw in progress
    std::vector<ColorPlanes> colors;  ///< of `primitives`, if narrow ones do not suffice
    TextureCache texture;

    std::size_t batches() const {
        return (primitives.size() + batch_capacity - 1) / batch_capacity;
    }
    void clear();
};

/// Draws a depth pass and records the fragments that may be visible.
void draw_recording(const TileDraw& draw, std::span<const std::uint32_t> bin,
                    VisibleRecord& record);
/// Completes the record for draws under Equal, from the depth pass if that drew it.
void record_primitives(const TileDraw& draw, std::span<const std::uint32_t> bin,
                       VisibleRecord& record);
/// Draws from a complete record.
void replay_primitives(const TileDraw& draw, VisibleRecord& record);

}  // namespace gw::fast
