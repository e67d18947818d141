// Texture coordinates at a vertex: the mesh's own, or generated. docs/manual.md, "Texture
// coordinates".
// Does not look anything up.
#pragma once

#include "gw/state.h"

namespace gw {

/// s, t, r, q. p_eye homogeneous, n_eye of length 1 or 0.
dvec4 texture_coordinates(const TextureState& state, const vec2& st, const dvec4& p_eye,
                          const dvec3& n_eye);

/// Where the sphere map shows what is seen in direction `d` (eye space, length 1): s, t in 0 .. 1.
/// [GL11] 2.10.4: m = 2 sqrt(dx^2 + dy^2 + (dz + 1)^2), s = dx / m + 1/2, t = dy / m + 1/2.
dvec2 sphere_map(const dvec3& d);

/// The direction of `u` (length 1, towards the surface) after reflection at normal n: u - 2 n (n .
/// u).
dvec3 reflected(const dvec3& u, const dvec3& n);
/// ... and after refraction, eta = n1 / n2; total reflection gives `reflected`.
dvec3 refracted(const dvec3& u, const dvec3& n, double eta);

}  // namespace gw
