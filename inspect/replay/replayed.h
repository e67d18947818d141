// A recording whose planes can be seen between any two passes. Goes forward as it can, and begins
// again to go back.
#pragma once

#include "gw/machine.h"
#include "inspect/replay/player.h"

#include <memory>
#include <vector>

namespace gw::inspect {

class Replayed {
public:
    /// `threads` of the machine; 0: all.
    explicit Replayed(Recording recording, int threads = 1);

    const Recording& recording() const { return recording_; }
    std::size_t passes() const { return ranges_.size(); }
    /// The planes after so many passes, until the next call.
    const Planes& planes_after(std::size_t passes);

private:
    Recording recording_;
    std::vector<PassRange> ranges_;
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<Player> player_;
    std::size_t done_ = 0;
    int threads_ = 1;
};

}  // namespace gw::inspect
