// Visible fragments found once: after a depth prepass, passes under Equal touch only the pixels whose depth a
// primitive has, and those are the same for every pass of the same geometry. Every primitive that ties is
// kept, never one a pixel. Does not draw; record.cpp makes a record, replay.cpp draws from it.
#pragma once

#include "gw/fast/primitive.h"
#include "gw/fast/setup.h"

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

/// Texture coordinates of a record's blocks, kept while draws ask for the same ones.
struct TextureCache {
    const VertexTexcoords* texcoords = nullptr;
    TextureState state;  ///< without the environment
    int log2_width = 0, log2_height = 0;
    std::vector<TexturePlanes> planes;  ///< of the record's primitives
    std::vector<TextureLanes> lanes;    ///< of its runs
    std::vector<std::uint8_t> divided;  ///< which of them are made
};

/// One draw's record in one tile.
struct Coverage {
    bool made = false;
    std::vector<std::uint32_t> primitives;  ///< ordinals in GeometrySet::primitives
    std::vector<VisibleBlock> blocks;       ///< by block; within one in the order of the primitives
    std::vector<DepthBlock> fragments;      ///< how many fragments each pixel gets (visible or not)
    std::uint64_t total = 0;                ///< their sum

    std::vector<BlockRun> runs;  ///< of `blocks`

    std::vector<NarrowBatch> narrow;  ///< of `primitives`, for the draw in progress
    std::vector<ColorPlanes> colors;  ///< the same where narrow ones do not serve
    TextureCache texture;

    void clear();
};

/// Gives draws that may share a record its number. A draw may where it compares Equal without changing depth
/// or stencil, has no alpha test, and where nothing but such draws has touched depth since the record was
/// made.
void plan_coverages(Segment& segment);

}  // namespace gw::fast
