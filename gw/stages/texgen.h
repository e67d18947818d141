// Texture coordinates at a vertex: the mesh's own, or generated. docs/manual/texture.md, "Texture
// coordinates". Does not look up texels.
#pragma once

#include "gw/command_list.h"

namespace gw {

/// A vertex as the rules of texture coordinates see it.
struct TexgenInput {
    dvec4 given{0, 0, 0, 1};  ///< s, t, r, q of the mesh, or the current ones
    dvec4 p_object{0, 0, 0, 1}, p_eye4{0, 0, 0, 1};
    dvec3 p_eye{0}, n_eye{0, 0, 1};  ///< the point in eye space, and the normal there
};

/// s, t, r, q.
dvec4 texture_coordinates(const TextureState& state, const TexgenInput& vertex);

/// Whether a draw's coordinates are divided by their q at each pixel: some q may differ from 1, or
/// the texture needs r.
bool divides_by_q(const TextureState& state, const Draw& draw, std::size_t unit = 0);

/// The sphere map's coordinates s, t in 0 .. 1 for direction `d` in eye space, of length 1.
/// [GL11] 2.10.4: m = 2 sqrt(dx^2 + dy^2 + (dz + 1)^2), s = dx / m + 1/2, t = dy / m + 1/2.
dvec2 sphere_map(const dvec3& d);

/// The direction of `u` after reflection at normal n: u - 2 n (n . u). `u` has length 1 and points
/// towards the surface.
dvec3 reflected(const dvec3& u, const dvec3& n);
/// The direction of `u` after refraction with eta = n1 / n2, or `reflected` at total reflection.
dvec3 refracted(const dvec3& u, const dvec3& n, double eta);

}  // namespace gw
