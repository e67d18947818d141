// Concave polygons as triangles. Does not know holes.
#include "irisgl/draw/primitives.h"

#include <cmath>
#include <numeric>

namespace gw::irisgl {

namespace {

/// The polygon in the plane of two axes where its area is largest, counter-clockwise.
std::vector<dvec2> flat(std::span<const Vertex> polygon) {
    dvec3 normal{0, 0, 0};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec4 &a = polygon[i].p, &b = polygon[(i + 1) % polygon.size()].p;
        normal += cross3({a.x, a.y, a.z}, {b.x, b.y, b.z});
    }
    int skip = 2;
    for (const int axis : {0, 1})
        if (std::abs(normal[axis]) > std::abs(normal[skip])) skip = axis;
    const int u = (skip + 1) % 3, v = (skip + 2) % 3;
    std::vector<dvec2> out;
    for (const Vertex& at : polygon)
        out.push_back(normal[skip] < 0 ? dvec2{at.p[v], at.p[u]} : dvec2{at.p[u], at.p[v]});
    return out;
}

double area(const dvec2& a, const dvec2& b, const dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_inside(const dvec2& p, const dvec2& a, const dvec2& b, const dvec2& c) {
    return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

bool is_ear(const std::vector<dvec2>& at, const std::vector<std::size_t>& left, std::size_t i) {
    const std::size_t n = left.size();
    const std::size_t before = left[(i + n - 1) % n], here = left[i], after = left[(i + 1) % n];
    if (!(area(at[before], at[here], at[after]) > 0)) return false;
    for (const std::size_t other : left) {
        if (other == before || other == here || other == after) continue;
        if (at[other] == at[before] || at[other] == at[here] || at[other] == at[after]) continue;
        if (is_inside(at[other], at[before], at[here], at[after])) return false;
    }
    return true;
}

}  // namespace

std::vector<Vertex> tessellated(std::span<const Vertex> polygon) {
    const std::vector<dvec2> at = flat(polygon);
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), std::size_t(0));
    std::vector<Vertex> out;
    while (left.size() >= 3) {
        const std::size_t n = left.size();
        std::size_t ear = n;
        for (std::size_t i = 0; i < n && ear == n; ++i)
            if (is_ear(at, left, i)) ear = i;
        if (ear == n) ear = 1;  // it crosses itself, or has no area: any cut ends
        const std::size_t before = left[(ear + n - 1) % n], after = left[(ear + 1) % n];
        out.insert(out.end(), {polygon[before], polygon[left[ear]], polygon[after]});
        left.erase(left.begin() + std::ptrdiff_t(ear));
    }
    return out;
}

}  // namespace gw::irisgl
