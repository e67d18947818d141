#include "gw/mesh/triangulate.h"

#include "gw/mesh/ear_clipper.h"
#include "gw/mesh/orient.h"

#include <glm/common.hpp>

#include <array>
#include <utility>

namespace gw {
namespace {

// Newell's normal and the sum of its terms' magnitudes, which still gives an axis if the normal is
// zero.
struct Newell {
    dvec3 normal{0}, magnitude{0};
};

Newell newell(std::span<const vec3> corners) {
    Newell sum;
    const dvec3 origin = corners[0];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const dvec3 a = dvec3(corners[i]) - origin, b = dvec3(corners[i + 1]) - origin;
        const dvec3 term{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
        sum.normal += term;
        sum.magnitude += glm::abs(term);
    }
    return sum;
}

// The largest component; z, then y, if components are equal.
int main_axis(const dvec3& v) {
    if (v.z >= v.x && v.z >= v.y) return 2;
    return v.y >= v.x ? 1 : 0;
}

bool rightward(vec2 a, vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// Whether the polygon turns left or runs straight at every corner, and turns round only once. Then
// the corners ascend by (x, y) in one run of sides.
bool convex(std::span<const vec2> corners) {
    int reversals = 0;
    vec2 a = corners[corners.size() - 2], b = corners.back();
    for (const vec2& c : corners) {
        if (a == b || orient(a, b, c) < 0) return false;
        reversals += rightward(a, b) != rightward(b, c);
        a = std::exchange(b, c);
    }
    return reversals == 2;
}

// Whether four corners turn left beyond doubt. Then they turn round only once.
bool turn_left(const std::array<vec2, 8>& corners) {
    bool left = true;
    for (std::size_t i = 0; i < 4; ++i)
        left &= turns_left(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
    return left;
}

bool fan_has_area(std::span<const vec2> corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        if (orient(corners[0], corners[i], corners[i + 1]) <= 0) return false;
    return true;
}

std::vector<PolygonTriangle> fan(std::uint32_t n) {
    std::vector<PolygonTriangle> triangles;
    triangles.reserve(n - 2);
    for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({{0, i, i + 1}});
    return triangles;
}

void flag_sides(std::vector<PolygonTriangle>& triangles, std::uint32_t n) {
    for (PolygonTriangle& t : triangles)
        for (unsigned k = 0; k < 3; ++k)
            if ((t.corner[k] + 1) % n == t.corner[(k + 1) % 3])
                t.edges |= static_cast<std::uint8_t>(1u << k);
}

/// As project_polygon(), into as many points.
void project_into(std::span<const vec3> corners, vec2* points) {
    const auto [normal, magnitude] = newell(corners);
    const int axis = main_axis(normal == dvec3(0) ? magnitude : glm::abs(normal));
    const bool flip = normal[axis] < 0;
    const int first = flip ? (axis + 2) % 3 : (axis + 1) % 3;
    const int second = flip ? (axis + 1) % 3 : (axis + 2) % 3;
    for (const vec3& p : corners) *points++ = vec2(p[first], p[second]);
}

bool is_simple(std::span<const vec2> corners) {
    return corners.size() == 3 || (convex(corners) && fan_has_area(corners));
}

}  // namespace

std::vector<vec2> project_polygon(std::span<const vec3> corners) {
    std::vector<vec2> points(corners.size());
    project_into(corners, points.data());
    return points;
}

bool becomes_fan(std::span<const vec3> corners) {
    std::array<vec2, 8> points;
    if (corners.size() > points.size()) return is_simple(project_polygon(corners));
    project_into(corners, points.data());
    if (corners.size() == 4 && turn_left(points)) return true;
    return is_simple(std::span(points).first(corners.size()));
}

std::vector<PolygonTriangle> triangulate(std::span<const vec2> corners) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    std::vector<PolygonTriangle> triangles = is_simple(corners) ? fan(n) : clip_ears(corners);
    flag_sides(triangles, n);
    return triangles;
}

std::vector<PolygonTriangle> triangulate(std::span<const vec3> corners) {
    return triangulate(std::span<const vec2>(project_polygon(corners)));
}

}  // namespace gw
