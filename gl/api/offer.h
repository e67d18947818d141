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

/// What a version has beyond 1.1 that not every machine has.
inline constexpr Offer needs_of_versions[] = {
    {12, &Extensions::secondary_color},  // separate highlights
    {12, &Extensions::texture_3d},      {12, &Extensions::texture_lod},
    {13, &Extensions::texture_combine}, {13, &Extensions::texture_cube},
    {13, &Extensions::texture_formats}, {13, &Extensions::texture_units},
    {13, &Extensions::texture_wraps},   {14, &Extensions::blend_color},
    {14, &Extensions::blend_minmax},    {14, &Extensions::blend_separate},
    {14, &Extensions::blend_square},    {14, &Extensions::blend_subtract},
    {14, &Extensions::fog_coordinate},  {14, &Extensions::point_parameters},
    {14, &Extensions::stencil_wrap},    {14, &Extensions::texture_depth},
    {15, &Extensions::occlusion_query},
};

/// The version that is whole on a machine of the profile, at most `version`: GL_VERSION.
constexpr int whole_version(const Profile& profile, int version) {
    for (const Offer& need : needs_of_versions)
        if (need.version <= version && !(profile.extensions.*need.feature)) return need.version - 1;
    return version;
}

}  // namespace gw::gl
