// A workload as a command list of the machine. Does not run it.
#pragma once

#include "bench/peers/frame.h"
#include "bench/peers/workload.h"

namespace gw::peers {

CommandList command_list(const Workload& workload, const Frame& frame);

/// The same from another eye, so near that no picture changes. The machine cannot reuse kept data
/// of the other frame.
CommandList moved(CommandList list);

}  // namespace gw::peers
