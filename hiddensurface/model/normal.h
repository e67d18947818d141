// A polygon's normal and whether it faces the eye. Does not project.
#pragma once

#include "gw/base/types.h"

#include <span>

namespace gw::hiddensurface {

/// [L4] N = (P_i - P_j) x (P_j - P_k), towards the side from which i, j, k run counter-clockwise.
constexpr dvec3 face_normal(const dvec3& pi, const dvec3& pj, const dvec3& pk) {
    return cross3(pi - pj, pj - pk);
}

/// A polygon's normal for any corners: [L4] summed over the fan (P_0, P_k, P_k+1). Its length is
/// twice the area. Corners on one line add nothing; reflex corners of a concave polygon subtract.
constexpr dvec3 polygon_normal(std::span<const dvec3> p) {
    dvec3 n(0);
    for (std::size_t k = 1; k + 1 < p.size(); ++k) n += face_normal(p[0], p[k], p[k + 1]);
    return n;
}

/// [L3] D_f = (P_E - P_i).N: > 0 front, < 0 back, 0 edge-on.
constexpr double facing(const dvec3& p_eye, const dvec3& pi, const dvec3& n) {
    return dot3(p_eye - pi, n);
}

/// The same for an eye in homogeneous coordinates: (P_E, 1), or (direction to the eye, 0) if all
/// lines of sight are parallel.
constexpr double facing(const dvec4& eye, const dvec3& pi, const dvec3& n) {
    return dot3(dvec3(eye) - eye.w * pi, n);
}

/// A plane n.p + d = 0 as (n, d), and the side on which a point lies: > 0 on the normal's.
constexpr dvec4 plane_of(const dvec3& n, const dvec3& through) { return {n, -dot3(n, through)}; }
constexpr double side(const dvec4& plane, const dvec3& p) {
    return dot3(dvec3(plane), p) + plane.w;
}

}  // namespace gw::hiddensurface
