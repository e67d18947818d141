#include "radiosity/display/nearest_point.h"

#include <algorithm>
#include <limits>

namespace gw::radiosity {
namespace {

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

bool is_inside(const Triangle2& triangle, const dvec2& uv) {
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double side = cross2(triangle[(k + 1) % 3] - triangle[k], uv - triangle[k]);
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

class Nearest {
public:
    explicit Nearest(const dvec3& p) : p_(p) {}
    SurfacePoint best{.distance = std::numeric_limits<double>::infinity()};

    void look_at(std::uint32_t number, const Facet& facet) {
        for (const Triangle2& triangle : facet.triangles) {
            const dvec2 foot = facet.texel_of(p_);  // along the plane's normal
            if (is_inside(triangle, foot)) {
                take(number, facet, foot);
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k)
                look_at_edge(number, facet, triangle[k], triangle[(k + 1) % 3]);
        }
    }

private:
    void look_at_edge(std::uint32_t number, const Facet& facet, const dvec2& a, const dvec2& b) {
        const dvec3 from = facet.at(a), along = facet.at(b) - from;
        const double length2 = dot3(along, along);
        const double s = length2 > 0 ? std::clamp(dot3(p_ - from, along) / length2, 0.0, 1.0) : 0.0;
        take(number, facet, a + s * (b - a));
    }

    void take(std::uint32_t number, const Facet& facet, const dvec2& uv) {
        const double distance = length(facet.at(uv) - p_);
        if (distance < best.distance) best = {number, uv, distance};
    }

    dvec3 p_;
};

}  // namespace

SurfacePoint nearest_point(const PixmapModel& model, const dvec3& p) {
    Nearest nearest(p);
    for (std::uint32_t i = 0; i < model.facets.size(); ++i) nearest.look_at(i, model.facets[i]);
    return nearest.best;
}

}  // namespace gw::radiosity
