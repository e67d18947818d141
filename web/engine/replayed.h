// A recording whose planes can be seen between any two passes. Goes forward as it can, and begins
// again to go back.
#pragma once

#include "gw/machine.h"
#include "inspect/replay/player.h"

#include <memory>
#include <vector>

namespace gw::lab {

class Replayed {
public:
    explicit Replayed(inspect::Recording recording);

    const inspect::Recording& recording() const { return recording_; }
    std::size_t passes() const { return ranges_.size(); }
    /// The planes after so many passes, until the next call.
    const Planes& planes_after(std::size_t passes);

private:
    inspect::Recording recording_;
    std::vector<inspect::PassRange> ranges_;
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<inspect::Player> player_;
    std::size_t done_ = 0;
};

}  // namespace gw::lab
