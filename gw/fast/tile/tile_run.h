// Runs a segment's operations on every tile, on all threads. Does not plan and does not know
// vectors: gw/fast/tile/draw.h and the other kernels do.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/plan.h"
#include "gw/fast/plan/tile_draw.h"

#include <memory>
#include <span>
#include <vector>

namespace gw::fast {

/// Each worker thread keeps its scratch memory from tile to tile and from list to list.
struct TileScratch;
class TileRunner {
public:
    explicit TileRunner(int threads);
    ~TileRunner();

    /// Runs the operations of all tiles, on the frame of each sample. Returns the counts by slot.
    std::vector<OpCounts> run(const Segment& segment, std::span<Frame* const> frames,
                              const Profile& profile);

private:
    std::vector<std::unique_ptr<TileScratch>> scratch_;  ///< by worker
};

/// The contribution of an operation's counts to its pass.
Counters counters_of(const TileOp& op, const OpCounts& counts, const Profile& profile);

/// Copy and CopyTexture run on the host's planes, between segments. copy_pixels returns the number
/// of pixels.
std::uint64_t copy_pixels(const Copy& command, const Resolved& state, Planes& planes);
Texels copied_texels(const CopyTexture& command, ReadBuffer from, const Planes& planes,
                     const Profile& profile);

}  // namespace gw::fast
