// One wrong value in a valid list: a mask, an enumeration, a number or a size. Most results are
// invalid lists; some are valid with an unusual value. Does not run them.
#pragma once

#include "conformance/generate/case.h"

namespace gw::fuzz {

/// Changes one field of one command.
void corrupt(Random& random, CommandList& list);

}  // namespace gw::fuzz
