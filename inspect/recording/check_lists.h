// The limits of a recording's lists. Does not know how they are stored.
#pragma once

#include "gw/machine.h"
#include "inspect/recording/recording.h"

namespace gw::inspect {

/// Changes `context` as the execution of a valid list does.
void follow(const CommandList& list, ListContext& context);

/// Throws Error "list 0: command 12 (Draw) of pass 'diffuse': ..." if a list is not valid after
/// those before it.
void validate_lists(const Recording& recording);
/// The same, and throws Error if the limits are exceeded.
void check_lists(const Recording& recording, const Limits& limits);

}  // namespace gw::inspect
