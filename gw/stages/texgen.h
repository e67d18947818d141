// Texture coordinates at a vertex: the mesh's own, or generated. docs/manual/texture.md, "Texture
// coordinates". Does not look up texels.
#pragma once

#include "gw/state.h"

namespace gw {

/// s, t, r, q. p_eye is homogeneous, n_eye has length 1 or 0.
dvec4 texture_coordinates(const TextureState& state, const vec2& st, const dvec4& p_eye,
                          const dvec3& n_eye);

/// The sphere map's coordinates s, t in 0 .. 1 for direction `d` in eye space, of length 1.
/// [GL11] 2.10.4: m = 2 sqrt(dx^2 + dy^2 + (dz + 1)^2), s = dx / m + 1/2, t = dy / m + 1/2.
dvec2 sphere_map(const dvec3& d);

/// The direction of `u` after reflection at normal n: u - 2 n (n . u). `u` has length 1 and points
/// towards the surface.
dvec3 reflected(const dvec3& u, const dvec3& n);
/// The direction of `u` after refraction with eta = n1 / n2, or `reflected` at total reflection.
dvec3 refracted(const dvec3& u, const dvec3& n, double eta);

}  // namespace gw
