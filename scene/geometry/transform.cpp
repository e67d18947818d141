#include "scene/geometry/transform.h"

#include "gw/base/elementary.h"

#include <cmath>

namespace gw::scene {

dmat4 translation(const dvec3& by) {
    dmat4 m(1);
    m[3] = dvec4(by, 1);
    return m;
}

dmat4 scaling(const dvec3& by) {
    dmat4 m(1);
    for (int i = 0; i < 3; ++i) m[i][i] = by[i];
    return m;
}

// Rodrigues: c I + (1 - c) a a^T + s [a]x, columns first.
dmat4 rotation(const dvec3& axis, double degrees) {
    const dvec3 a = axis / std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    const double c = cos_degrees(degrees), s = sin_degrees(degrees), k = 1 - c;
    dmat4 m(1);
    m[0] = {c + k * (a.x * a.x), k * (a.x * a.y) + s * a.z, k * (a.x * a.z) - s * a.y, 0};
    m[1] = {k * (a.y * a.x) - s * a.z, c + k * (a.y * a.y), k * (a.y * a.z) + s * a.x, 0};
    m[2] = {k * (a.z * a.x) + s * a.y, k * (a.z * a.y) - s * a.x, c + k * (a.z * a.z), 0};
    return m;
}

dmat4 rotation_xyz(const dvec3& degrees) {
    return rotation({0, 0, 1}, degrees.z) * rotation({0, 1, 0}, degrees.y) *
           rotation({1, 0, 0}, degrees.x);
}

}  // namespace gw::scene
