// Running a segment's operations on every tile, on all threads.
// Does not plan, and does not know vectors: kernels.h does.
#pragma once

#include "gw/fast/plan/plan.h"

#include <memory>

namespace gw::fast {

/// Fragments of one operation by fate, or its pixels; summed over tiles.
struct OpCounts {
    std::uint64_t fragments = 0, alpha_killed = 0, stencil_killed = 0, depth_killed = 0,
                  written = 0;
    std::uint64_t pixels = 0, accum_overflows = 0;
    OpCounts& operator+=(const OpCounts& other);
};

/// What a worker keeps from tile to tile and from list to list, so that it need not be made anew.
struct WorkerRoom;
struct DeleteRoom {
    void operator()(WorkerRoom* room) const;
};
using WorkerRooms = std::vector<std::unique_ptr<WorkerRoom, DeleteRoom>>;

/// Runs all operations on all tiles; the counts by operation.
std::vector<OpCounts> run_tiles(const Segment& segment, Frame& frame, const Profile& profile,
                                int threads, WorkerRooms& rooms);

/// What an operation's counts add to its pass.
Counters counters_of(const TileOp& op, const OpCounts& counts, const Profile& profile);

/// Copy and CopyTexture run on the host's planes, between segments. The number of pixels copied.
std::uint64_t copy_pixels(const Copy& command, const Resolved& state, Planes& planes);
Texels copied_texels(const CopyTexture& command, const Planes& planes, const Profile& profile);

}  // namespace gw::fast
