// The frames of each window that are recorded, counted and shown: GW_FRAMES.
#pragma once

#include <cstdint>
#include <limits>

namespace gw::gl {

struct FrameRange {
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max();
    bool holds(std::uint64_t frame) const { return first <= frame && frame <= last; }
};

/// GW_FRAMES: "10-12" or "12"; all if it is not set. A wrong value is reported and ignored.
FrameRange read_frame_range();

}  // namespace gw::gl
