// The first thing in which two recordings tell a machine something different. Does not execute
// them.
#pragma once

#include "inspect/compare/finding.h"
#include "inspect/recording/recording.h"

namespace gw::inspect {

/// Profile, window, then command by command: its kind, the state's field, the mesh's array and
/// element, the map, the lights, ... Meshes, maps and lights are compared by content; how commands
/// are cut into lists does not count. Values are `a`'s (expected) and `b`'s.
std::optional<Finding> first_command_difference(const Recording& a, const Recording& b);

}  // namespace gw::inspect
