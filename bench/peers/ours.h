// A workload as a command list of the machine. Does not run it.
#pragma once

#include "bench/peers/frame.h"
#include "bench/peers/workload.h"

namespace gw::peers {

CommandList command_list(const Workload& workload, const Frame& frame);

/// The same from so near by that no picture changes: nothing that a machine keeps of a frame serves
/// the other.
CommandList moved(CommandList list);

}  // namespace gw::peers
