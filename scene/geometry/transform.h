// Placing an object: matrices whose bits are the same on every machine (gw/base/elementary.h, no
// libm). Does not know TOML.
#pragma once

#include "gw/base/types.h"

namespace gw::scene {

dmat4 translation(const dvec3& by);
dmat4 scaling(const dvec3& by);
/// A matrix with an inverse in place of one that flattens all to a plane; others stay as they are. A
/// millionth of its size is left across: normals are those of the plane, and nothing is mirrored.
dmat4 thickened(const dmat4& m);

/// Right-handed about an axis of any length but 0; multiples of 90 degrees about x, y, z are exact.
dmat4 rotation(const dvec3& axis, double degrees);

/// About x, then y, then z.
dmat4 rotation_xyz(const dvec3& degrees);

}  // namespace gw::scene
