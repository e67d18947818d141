// What the user chose by environment variables: GW_PROFILE, GW_THREADS.
#pragma once

#include "gw/profile.h"

namespace gw::gl {

struct Settings {
    Profile profile;  ///< GW_PROFILE: a name; opengl if it is not set
    int threads = 0;  ///< GW_THREADS; 0: all
};

/// Read once. Throws Error if a variable's value is wrong.
const Settings& settings();

}  // namespace gw::gl
