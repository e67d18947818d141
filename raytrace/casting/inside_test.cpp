#include "raytrace/casting/inside_test.h"

#include "gw/base/elementary.h"

#include <cmath>

namespace gw::raytrace {
namespace {

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

bool inside_by_crossings(const dvec2& p, std::span<const dvec2> corners) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y >= p.y) == (b.y >= p.y)) continue;
        const dvec2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
        // Right of p: x(p.y) > p.x, multiplied by the side's height.
        const double height = high.y - low.y;
        if ((high.x - low.x) * (p.y - low.y) > (p.x - low.x) * height) inside = !inside;
    }
    return inside;
}

bool inside_by_cross_products(const dvec2& p, std::span<const dvec2> corners) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double c = cross2(b - a, p - a);
        left = left || c > 0;
        right = right || c < 0;
    }
    return left != right;
}

bool inside_by_angles(const dvec2& p, std::span<const dvec2> corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 a = corners[i] - p, b = corners[(i + 1) % corners.size()] - p;
        const double sine = cross2(a, b), cosine = a.x * b.x + a.y * b.y;
        if (sine == 0 && cosine <= 0) return true;  // on the side
        sum += gw::atan2(sine, cosine);
    }
    return std::abs(sum) > pi;
}

bool inside(InsideTest test, const dvec2& p, std::span<const dvec2> corners) {
    switch (test) {
        case InsideTest::Crossings: return inside_by_crossings(p, corners);
        case InsideTest::CrossProducts: return inside_by_cross_products(p, corners);
        case InsideTest::Angles: return inside_by_angles(p, corners);
    }
    return false;
}

}  // namespace gw::raytrace
