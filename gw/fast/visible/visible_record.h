// Visible fragments found once: after a depth prepass, passes under Equal touch only the pixels
// whose depth a primitive has, and those are the same for every pass of the same geometry. Every
// primitive that ties is kept, never one a pixel. Does not draw; record.cpp makes a record,
// replay.cpp draws from it.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/raster/primitive.h"
#include "gw/fast/raster/setup.h"

#include <cstdint>
#include <vector>

namespace gw::fast {

struct Segment;

/// Pixels of one block where a primitive's depth equals the stored one.
struct VisibleBlock {
    std::uint16_t block = 0, mask = 0;
    std::uint32_t primitive = 0;  ///< in Coverage::primitives
};
/// The entries of one block: blocks[first .. first + count - 1].
struct BlockRun {
    std::uint16_t block = 0, mask = 0;  ///< lanes of all entries
    bool tied = false;                  ///< some lane has two
    std::uint32_t first = 0, count = 0;
};

/// What the texture unit found in a record's blocks, kept while draws ask for the same.
struct TextureCache {
    const VertexTexcoords* texcoords = nullptr;
    const FastTexels* texels = nullptr;
    TextureState state;                 ///< without the environment
    std::vector<TexturePlanes> planes;  ///< of the record's primitives
    std::vector<ColorBlock> found;      ///< of its runs, all their lanes
    std::vector<std::uint8_t> made;     ///< which of them are
};

/// One draw's record in one tile.
struct Coverage {
    bool drawn = false;  ///< the depth pass left what may be visible in `primitives` and `blocks`
    bool made = false;
    std::vector<std::uint32_t> primitives;  ///< ordinals in GeometrySet::primitives
    std::vector<TilePlane> depth;           ///< of `primitives`, until the record is made
    /// by block; within one in the order of the primitives
    std::vector<VisibleBlock> blocks;
    /// how many fragments each pixel gets, where a draw asks
    std::vector<DepthBlock> fragments;
    std::uint64_t total = 0;  ///< fragments of the draw, visible or not

    std::vector<BlockRun> runs;          ///< of `blocks`
    std::vector<VisibleBlock> by_block;  ///< room to sort `blocks`

    /// of `primitives`, a batch each; what follows the last is of no use
    std::vector<Corners> corners;
    std::vector<NarrowBatch> narrow;  ///< the same, for the draw in progress
    std::vector<ColorPlanes> colors;  ///< of `primitives` where narrow ones do not serve
    TextureCache texture;

    std::size_t batches() const { return (primitives.size() + batch_room - 1) / batch_room; }
    void clear();
};

/// Gives draws that may share a record its number. A draw may where it compares Equal, has no alpha
/// test, and where nothing but such draws has touched depth since the record was made; stencil
/// operations only on what is visible, all of it. The depth pass of the same geometry makes the
/// record on its way, where between the two depths only became less: then no fragment that failed
/// in it can be visible.
void plan_coverages(Segment& segment);

}  // namespace gw::fast
