// Shortens a failing list: leaves out commands and triangles while it still fails. Does not change
// the remaining ones.
#pragma once

#include "tests/fuzz/run.h"

namespace gw::fuzz {

/// A shorter case that fails on the same machines: first with fewer commands, then with fewer
/// primitives.
Case shrink(Case c, const MachineMaker& a, const MachineMaker& b);

}  // namespace gw::fuzz
