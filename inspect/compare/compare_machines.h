// The same recording on two machines: the proof that they are the same machine, or the first pass,
// plane and pixel that differ. Does not know which machines they are.
#pragma once

#include "gw/machine.h"
#include "inspect/compare/finding.h"
#include "inspect/recording/recording.h"
#include "inspect/replay/player.h"

#include <string>
#include <vector>

namespace gw::inspect {

/// "reference" or "fast" (on `threads` threads; 0: all).
MachineMaker maker_of(const std::string& machine, int threads = 0);

/// Reports of all passes, with digests of all planes.
std::vector<PassReport> reports_of(const Recording& recording, const MachineMaker& make);

/// Nothing: every counter and every plane after every pass is the same. `expected` is right by
/// definition.
std::optional<Finding> compare_machines(const Recording& recording, const MachineMaker& expected,
                                        const MachineMaker& actual);

/// Adds to a difference in a pass that two machines made of the same commands: the first pixel,
/// both values, the command that made it. Leaves it as it is if their planes agree.
void locate(Finding& finding, const Recording& recording, const MachineMaker& expected,
            const MachineMaker& actual);

}  // namespace gw::inspect
