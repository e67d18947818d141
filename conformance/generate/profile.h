// Random profiles: built-in and user-defined ones. Does not make invalid ones.
#pragma once

#include "conformance/generate/random.h"
#include "gw/profile.h"

namespace gw::fuzz {

Profile any_profile(Random& random);
/// Every field has a random value of its range.
Profile user_profile(Random& random);

}  // namespace gw::fuzz
