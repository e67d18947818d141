// One accumulation command on a block, behind run-time dispatch.
#pragma once

#include "gw/fast/frame/frame.h"
#include "gw/fast/plan/plan.h"

#include <cstdint>

namespace gw::fast {

/// The lanes of `mask`; returns how many channels overflowed.
std::uint64_t accumulate_block(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                               ColorBlock& color, std::uint32_t mask);

}  // namespace gw::fast
