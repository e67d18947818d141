// Facets from points and their ST, with everything derived from them.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <optional>

namespace gw::radiosity {

/// The affine map that gives three points of a plane these texel coordinates; none where they have
/// no area.
std::optional<Facet> facet_of(const std::array<dvec3, 3>& p, const std::array<dvec2, 3>& uv);

/// The map u = 0, v = 0 at `origin`, one texel along du and along dv.
Facet facet_along(const dvec3& origin, const dvec3& du, const dvec3& dv, const dvec3& normal);

/// After its triangles are in: bounds, the region's corners, the sphere.
void finish(Facet& facet);

}  // namespace gw::radiosity
