// A list made ready to run tile by tile: every command becomes an operation on tiles, and draws
// share geometry and vertex values. The bits are the reference machine's; nothing else is promised.
// Does not touch pixels.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/kept_geometry.h"
#include "gw/fast/plan/texels.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/machine.h"

#include <array>
#include <deque>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace gw::fast {

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
    int visible_records = 0;
};

/// The part of a machine's state that planning needs; persists from list to list.
struct MachineState {
    State state;
    std::vector<PassReport> passes;
    std::map<std::uint32_t, FastTexels> slots;
    std::map<std::uint32_t, Plane> slot_planes;
    std::map<TextureRef, std::unique_ptr<FastTexels>> texels;
    std::map<std::uint32_t, Readback> readbacks;
    ReadTargets targets;  ///< of the list in execution
    KeptGeometry geometry;
    Segment recycled;  ///< the last one, emptied: the next reuses its memory
};

/// Plans the commands up to the next barrier (which is not included) and counts their geometry.
/// `consumed`: how many commands that were.
Segment plan_segment(std::span<const Command> commands, MachineState& machine,
                     const Profile& profile, const TileGrid& grid, int threads,
                     std::size_t& consumed);

/// Takes back a segment that has run: the next one reuses its memory.
void retire(Segment segment, MachineState& machine);

/// Gives draws that may share a record of visible fragments its number. A draw may if it compares
/// Equal, has no alpha test and changes the stencil only where it is visible, everywhere there; and
/// if only such draws have touched depth since the record was made. The depth pass of the same
/// geometry makes the record on its way, if depths only became less between the two: then no
/// fragment that failed in it can be visible.
void share_visibility(Segment& segment);

/// Whether a command reads pixels across tiles, or takes digests: it runs between segments.
bool is_barrier(const Command& command, const std::vector<PassReport>& passes);

}  // namespace gw::fast
