#include "raytrace/casting/intersect.h"

#include "gw/base/elementary.h"

#include <cmath>

namespace gw::raytrace {
namespace {

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

dvec3 summed_normal(const std::vector<dvec3>& p) {
    dvec3 n(0);
    for (std::size_t k = 1; k + 1 < p.size(); ++k) n += cross3(p[k] - p[0], p[k + 1] - p[0]);
    return n;
}

dvec2 without(const dvec3& p, int axis) {
    return axis == 0 ? dvec2(p.y, p.z) : axis == 1 ? dvec2(p.z, p.x) : dvec2(p.x, p.y);
}

}  // namespace

bool crosses(const dvec2& p, const dvec2& a, const dvec2& b) {
    if ((a.y >= p.y) == (b.y >= p.y)) return false;
    const dvec2 &low = a.y < b.y ? a : b, &high = a.y < b.y ? b : a;
    // Right of p: x(p.y) > p.x, multiplied by the side's height.
    const double height = high.y - low.y;
    return (high.x - low.x) * (p.y - low.y) > (p.x - low.x) * height;
}

double side_product(const dvec2& p, const dvec2& a, const dvec2& b) { return cross2(b - a, p - a); }

std::optional<double> seen_angle(const dvec2& p, const dvec2& from, const dvec2& to) {
    const dvec2 a = from - p, b = to - p;
    const double sine = cross2(a, b), cosine = a.x * b.x + a.y * b.y;
    if (sine == 0 && cosine <= 0) return std::nullopt;
    return gw::atan2(sine, cosine);
}

bool inside_by_crossings(const dvec2& p, std::span<const dvec2> corners) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (crosses(p, corners[i], corners[(i + 1) % corners.size()])) inside = !inside;
    return inside;
}

bool inside_by_cross_products(const dvec2& p, std::span<const dvec2> corners) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double c = side_product(p, corners[i], corners[(i + 1) % corners.size()]);
        left = left || c > 0;
        right = right || c < 0;
    }
    return left != right;
}

bool inside_by_angles(const dvec2& p, std::span<const dvec2> corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto angle = seen_angle(p, corners[i], corners[(i + 1) % corners.size()]);
        if (!angle) return true;  // on the side
        sum += *angle;
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

PlanePolygon plane_polygon(std::vector<dvec3> corners, int axis) {
    const dvec3 normal = summed_normal(corners);
    return {std::move(corners), normal, axis};
}

PlanePolygon plane_polygon(std::vector<dvec3> corners) {
    PlanePolygon polygon = plane_polygon(std::move(corners), 0);
    const dvec3& n = polygon.normal;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(n[axis]) > std::abs(n[polygon.axis])) polygon.axis = axis;
    return polygon;
}

std::optional<double> plane_parameter(const Ray& ray, const dvec3& point, const dvec3& normal) {
    const double slope = dot3(ray.direction, normal);
    if (slope == 0) return std::nullopt;
    return dot3(point - ray.origin, normal) / slope;
}

std::optional<double> intersect(const Ray& ray, const PlanePolygon& polygon, InsideTest test) {
    const auto t = plane_parameter(ray, polygon.corners.front(), polygon.normal);
    if (!t || !(*t > 0)) return std::nullopt;
    std::vector<dvec2> corners;
    for (const dvec3& corner : polygon.corners) corners.push_back(without(corner, polygon.axis));
    if (!inside(test, without(point_at(ray, *t), polygon.axis), corners)) return std::nullopt;
    return t;
}

std::optional<Hit> nearest_hit(const Ray& ray, std::span<const PlanePolygon> polygons) {
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto t = intersect(ray, polygons[i]);
        if (t && (!nearest || *t < nearest->t)) nearest = Hit{i, *t};
    }
    return nearest;
}

}  // namespace gw::raytrace
