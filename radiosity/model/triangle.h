// Distances from triangles. Does not know what they stand for.
#pragma once

#include "gw/base/types.h"

namespace gw::radiosity {

/// The point of a triangle that is nearest to p. The triangle has an area.
dvec3 nearest_point(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c);

}  // namespace gw::radiosity
