// The list that makes a new machine's planes equal to another's. A recording that starts in the
// middle of a program begins with it.
#pragma once

#include "gw/command_list.h"
#include "gw/planes.h"
#include "gw/profile.h"

#include <string>

namespace gw::gl {

/// One pass of this name. The machine's planes are 0; its state is the initial one, and `state`
/// afterwards.
CommandList restoring_list(const Planes& planes, const Profile& profile, const std::string& pass,
                           const gw::State& state);

}  // namespace gw::gl
