// What the doors offer: functions and extensions, by the version that the user lets them have and by
// the profile.
#pragma once

#include "gw/profile.h"

namespace gw::gl {

/// Versions of OpenGL as numbers: 1.5 is 15.
inline constexpr int first_version = 11, last_version = 15;

/// When a function or an extension is there.
struct Offer {
    int version;                ///< the version that has it, or that its extension belongs to
    bool Extensions::*feature;  ///< null: every machine has what it needs
};

/// `version`: the user's, GW_GL_VERSION.
inline bool is_offered(const Offer& offer, const Profile& profile, int version) {
    return offer.version <= version &&
           (offer.feature == nullptr || profile.extensions.*offer.feature);
}

}  // namespace gw::gl
