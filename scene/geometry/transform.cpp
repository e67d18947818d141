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

dmat4 thickened(const dmat4& m) {
    const auto longest_cross = [](const dvec3& a, const dvec3& b, const dvec3& c) {
        dvec3 longest(0);
        for (const dvec3& v : {cross3(a, b), cross3(b, c), cross3(c, a)})
            if (length(v) > length(longest)) longest = v;
        return longest;
    };
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    const dvec3 normal = longest_cross(x, y, z);
    const double size = std::sqrt(dot3(x, x) + dot3(y, y) + dot3(z, z)), area = length(normal);
    constexpr double least = 1e-12;
    if (area <= least * size * size) return m;
    if (std::abs(dot3(cross3(x, y), z)) > least * area * size) return m;
    // What the matrix loses: vectors of the object that are normal to all of its rows.
    const dvec3 lost = longest_cross({x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z});
    const dvec3 left = normal * (1e-6 * size / (area * length(lost)));
    dmat4 thick = m;
    for (int i = 0; i < 3; ++i) thick[i] += dvec4(left * lost[i], 0);
    if (dot3(cross3(dvec3(thick[0]), dvec3(thick[1])), dvec3(thick[2])) > 0) return thick;
    for (int i = 0; i < 3; ++i) thick[i] -= dvec4(2.0 * left * lost[i], 0);
    return thick;
}

dmat4 rotation_xyz(const dvec3& degrees) {
    return rotation({0, 0, 1}, degrees.z) * rotation({0, 1, 0}, degrees.y) *
           rotation({1, 0, 0}, degrees.x);
}

}  // namespace gw::scene
