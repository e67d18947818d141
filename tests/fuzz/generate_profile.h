// Profiles: the built-in ones, and users' own. Does not make invalid ones.
#pragma once

#include "gw/profile.h"
#include "tests/fuzz/random.h"

namespace gw::fuzz {

Profile any_profile(Random& random);
/// Every field anything in its range.
Profile user_profile(Random& random);

}  // namespace gw::fuzz
