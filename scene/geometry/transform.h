// Placing an object: matrices whose bits are the same on every machine (gw/base/elementary.h, no
// libm). Does not know TOML.
#pragma once

#include "gw/base/types.h"

namespace gw::scene {

dmat4 translation(const dvec3& by);
dmat4 scaling(const dvec3& by);

/// Right-handed about an axis of any length but 0; multiples of 90 degrees about x, y, z are exact.
dmat4 rotation(const dvec3& axis, double degrees);

/// About x, then y, then z.
dmat4 rotation_xyz(const dvec3& degrees);

}  // namespace gw::scene
