// A list made ready to run tile by tile: what is shared is made once, every command becomes an
// operation on a tile. docs/manual.md promises nothing about it: only that the bits are the
// reference machine's. Does not touch pixels.
#pragma once

#include "gw/fast/plan/kept_geometry.h"
#include "gw/fast/shade/texels.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/machine.h"

#include <array>
#include <deque>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace gw::fast {

struct DrawOp {
    const Draw* draw = nullptr;
    Resolved state;
    const GeometrySet* set = nullptr;
    const VertexColors* colors = nullptr;        ///< null where no colour is needed
    const VertexFog* fog = nullptr;              ///< null: no fog
    const VertexTexcoords* texcoords = nullptr;  ///< null: untextured
    const FastTexels* texels = nullptr;          ///< null: untextured
    const TexelPairs* pairs = nullptr;           ///< of `texels`, where its filter is bilinear
    /// textured, whether or not anyone sees the colour
    bool texels_counted = false;
    const std::vector<std::uint32_t>* fog_table = nullptr;
    bool needs_color = true;  ///< some plane or the alpha test sees it
    bool perspective_color = false;
    /// which record of visible fragments it makes or uses; -1: none
    int coverage = -1;
    bool counts_by_pixel = false;  ///< its record counts each pixel's fragments
    FragmentBytes bytes;
};
/// Whether its fragments meet the depth plane.
inline bool needs_depth(const DrawOp& op) {
    return op.state.state.depth.func != DepthFunc::Always || op.state.state.depth.mask;
}
/// The planes that it must find settled.
inline UniformPlanes touched_planes(const DrawOp& op) {
    return {op.state.writes_color, needs_depth(op)};
}

struct ClearOp {
    const Clear* clear = nullptr;
    Resolved state;
};
struct SpansOp {
    const WriteSpans* write = nullptr;
    Resolved state;
    FragmentBytes bytes;
};
struct PixelsOp {
    const WritePixels* write = nullptr;
    Resolved state;
    FragmentBytes bytes;
};
struct AccumulateOp {
    const Accumulate* accumulate = nullptr;
    Resolved state;
};
struct ReadOp {
    const Read* read = nullptr;
    // The first pixel of the result; one of the three is given.
    Rgba* color = nullptr;
    std::uint32_t* values = nullptr;
    std::array<std::int32_t, 4>* accum = nullptr;
};

/// An operation and the pass it is counted in.
struct TileOp {
    std::variant<DrawOp, ClearOp, SpansOp, PixelsOp, AccumulateOp, ReadOp> op;
    std::size_t pass = 0;
};

/// A run of commands without a barrier.
struct Segment {
    std::deque<TileOp> ops;
    std::deque<GeometrySet> sets;
    std::deque<VertexColors> colors;
    std::deque<VertexFog> fogs;
    std::deque<VertexTexcoords> texcoords;
    std::deque<std::vector<std::uint32_t>> fog_tables;
    bool uses_accum = false;
    int coverages = 0;  ///< records of visible fragments
};

/// What persists in a machine from list to list, as far as planning needs it.
struct MachineState {
    State state;
    std::vector<PassReport> passes;
    std::map<std::uint32_t, FastTexels> slots;
    std::map<std::uint32_t, Plane> slot_planes;
    std::map<TextureRef, std::unique_ptr<FastTexels>> texels;
    std::map<std::uint32_t, Readback> readbacks;
    ReadTargets targets;  ///< of the list in execution
    KeptGeometry geometry;
    Segment done;  ///< the last one, emptied: the next takes its memory
};

/// Plans the commands up to the next barrier (which is not included) and counts their geometry.
/// `done` is how many commands were taken.
Segment plan_segment(std::span<const Command> commands, MachineState& machine,
                     const Profile& profile, const TileGrid& grid, int threads, std::size_t& done);

/// Takes back what a segment that has run holds: its memory serves the next one.
void retire(Segment segment, MachineState& machine);

/// Whether a command reads pixels across tiles, or takes digests: it runs between segments.
bool is_barrier(const Command& command, const std::vector<PassReport>& passes);

}  // namespace gw::fast
