// Making a failing list shorter: commands and triangles left out while it still fails.
// Does not change what is left.
#pragma once

#include "tests/fuzz/run.h"

namespace gw::fuzz {

/// A case that fails on the same machines, with as few commands, then primitives, as leaving out
/// finds.
Case shrink(Case c, const MachineMaker& a, const MachineMaker& b);

}  // namespace gw::fuzz
