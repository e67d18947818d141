// One accumulation command on a block, behind run-time dispatch.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/plan.h"

#include <cstdint>

namespace gw::fast {

/// Runs the command on the lanes of `mask`. Returns the number of channels that overflowed.
std::uint64_t accumulate_block(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                               ColorBlock& color, std::uint32_t mask);

}  // namespace gw::fast
