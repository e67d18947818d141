// A manifest in which a pass that ran often stands once: what superposes a hundred pictures has
// thousands of passes, of a few names. Does not compare.
#pragma once

#include "inspect/manifest/manifest.h"

namespace gw::inspect {

/// A pass for each name, in the order of their first runs: "diffuse lamp, 16 runs" has the first
/// run's state and parameter set, the sums of the counters, and digests of the runs' digests. One
/// run stays as it is.
Manifest merge_runs(const Manifest& manifest);

}  // namespace gw::inspect
