// A list made ready to run tile by tile: every command becomes an operation on tiles, and draws
// share geometry and vertex values. The bits are the reference machine's; nothing else is promised.
// Does not touch pixels.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/kept_textures.h"
#include "gw/fast/plan/pool.h"
#include "gw/fast/plan/scan.h"
#include "gw/fast/vertices/geometry_scratch.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/machine.h"
#include "gw/stages/pixels/draw_pixels.h"

#include <deque>
#include <functional>
#include <map>
#include <span>
#include <variant>
#include <vector>

namespace gw::fast {

struct ClearOp {
    const Clear* clear;
    PlaneMask planes;  ///< that it names and the surface has
    const Resolved& state;
};
struct SpansOp {
    const WriteSpans* write;
    const Resolved& state;
    FragmentBytes bytes;
};
struct PixelsOp {
    const WritePixels* write;
    const Resolved& state;
    FragmentBytes bytes;
};
struct DrawPixelsOp {
    const PlacedPixels* placed;
    const Resolved& state;
    FragmentBytes bytes;
};
struct AccumulateOp {
    const Accumulate* accumulate;
    const Resolved& state;
};
struct ReadOp {
    const Read* read = nullptr;
    // The first pixel of the result. One of the three pointers is set.
    Rgba* color = nullptr;
    std::uint32_t* values = nullptr;
    std::array<std::int32_t, 4>* accum = nullptr;
    ReadLayout layout{};
};

/// An operation, the pass that it is counted in, and the slot that sums its counts.
struct TileOp {
    std::variant<DrawOp, ClearOp, SpansOp, PixelsOp, DrawPixelsOp, AccumulateOp, ReadOp> op;
    std::size_t pass = 0;
    std::uint32_t count_slot = 0;
};

struct FogTable {
    FogState of;  ///< without its colour
    std::vector<std::uint32_t> values;
};

/// A run of commands without a barrier. The next segment reuses its memory.
struct Segment {
    Scan scan;
    std::vector<TileOp> ops;
    std::vector<const Draw*> draws;  ///< of all draw operations
    Pool<VertexColors> colors;
    Pool<VertexFog> fogs;
    Pool<VertexTexcoords> texcoords;
    std::deque<FogTable> fog_tables;
    std::deque<PlacedPixels> placed_pixels;
    std::deque<UnitOps> unit_ops;
    std::vector<GeometryScratch> scratch;  ///< by worker
    bool uses_accum = false;
    bool uses_both_colors = false;
    int visible_records = 0;

    /// One operation of each slot. Operations with the same slot add to the same sum.
    std::vector<std::uint32_t> count_slots;
    /// Tile tiles[i] runs tile_ops[tile_start[i] .. tile_start[i + 1] - 1].
    std::vector<std::uint32_t> tiles, tile_start, tile_ops;
};

/// The part of a machine's state that planning needs; persists from list to list.
struct MachineState {
    Profile profile;  ///< of the machine and its textures; a surface has its own depth_bits
    State state;
    std::vector<PassReport> passes;
    std::map<std::uint32_t, FastTexels> slots;
    std::map<std::uint32_t, Plane> slot_planes;
    /// makes the texels that a surface's plane has now; valid until the segment ends
    std::function<FastTexels&(const SurfacePlane&, bool compared)> surface_texels;
    KeptTextures texels;
    std::map<std::uint32_t, Readback> readbacks;
    ReadTargets targets;  ///< of the list in execution
    KeptGeometry geometry;
    Segment segment;  ///< the one in progress
};

/// What a segment draws to.
struct SegmentTarget {
    Surface surface;
    const TileGrid& grid;
};

/// Plans the commands of the next segment, which ends before a barrier or when it is full, and
/// counts their geometry. Returns the number of commands.
std::size_t plan_segment(std::span<const Command> commands, MachineState& machine,
                         const Profile& profile, const SegmentTarget& target, int threads);

/// Ends a segment that has run: the next one reuses its memory.
void end_segment(MachineState& machine);

/// Numbers the records of visible fragments and gives each number to the draws that share the
/// record. A draw may use a record under three conditions. It compares Equal, without alpha test.
/// It changes the stencil of all its visible fragments or of none, and of no others. Only such
/// draws have touched depth since the record was made. The depth pass of the same geometry makes
/// the record if depths only became less between the two: then no fragment that failed in it can be
/// visible.
void share_visibility(Segment& segment);

/// Lists the operations by tile, and gives them their count slots.
void list_by_tile(Segment& segment, const TileGrid& grid);

}  // namespace gw::fast
