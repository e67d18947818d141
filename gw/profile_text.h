// A profile as one line of text, as an environment variable holds it: a built-in profile's name,
// then its changes. "opengl,depth_bits=32,stipple=0,name=mine". Files of profiles are scene's.
#pragma once

#include "gw/profile.h"

#include <string>
#include <string_view>

namespace gw {

/// The built-in profile's name if it is one, else all members.
std::string profile_text(const Profile& profile);

/// Of `profile_text`, or of a line that names fewer members. The name stands last, because it may
/// hold commas. Throws Error that names the first word that is wrong.
Profile profile_from_text(std::string_view text);

}  // namespace gw
