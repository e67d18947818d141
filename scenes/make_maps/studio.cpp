#include "scenes/make_maps/studio.h"

#include "scenes/make_maps/noise.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace gw::maps {
namespace {

// The way the view (0, 0, -1) is reflected where the ball's normal shows at st; outside the ball,
// as at its rim.
dvec3 reflected(dvec2 st) {
    dvec2 n = 2.0 * st - 1.0;
    const double length = glm::length(n);
    if (length > 1) n /= length;
    const double z = std::sqrt(std::max(0.0, 1 - n.x * n.x - n.y * n.y));
    return {2 * z * n.x, 2 * z * n.y, 2 * z * z - 1};
}

// 1 inside the rectangle |x - center| < half, fading over `soft`.
double inside(dvec2 p, dvec2 center, dvec2 half, double soft) {
    const dvec2 d = glm::abs(p - center) - half;
    return (1 - ramp(0, soft, d.x)) * (1 - ramp(0, soft, d.y));
}

// The point where the direction meets the wall of a big room, x to the right of the wall's middle;
// nothing behind.
bool on_wall(const dvec3& r, const dvec3& wall, const dvec3& right, const dvec3& up, dvec2& p) {
    const double ahead = glm::dot(r, wall);
    if (ahead <= 0.05) return false;
    p = dvec2(glm::dot(r, right), glm::dot(r, up)) / ahead;
    return true;
}

double soft_box(const dvec3& r) {
    dvec2 p;
    return on_wall(r, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}, p)
               ? inside(p, {0.1, -0.35}, {0.75, 0.4}, 0.12)
               : 0;
}

double window(const dvec3& r) {
    dvec2 p;
    if (!on_wall(r, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}, p)) return 0;
    double light = 0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            light += inside(p, {-0.75 + 0.5 * i, -0.1 + 0.42 * j}, {0.2, 0.17}, 0.03);
    return light;
}

double lamps(const dvec3& r) {
    dvec2 p;
    if (!on_wall(r, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, p)) return 0;
    double light = 0;
    for (int i = 0; i < 4; ++i)
        light += 1 - ramp(0.06, 0.12, glm::length(p - dvec2(-0.6 + 0.5 * i, 0.7)));
    return light;
}

}  // namespace

Color studio(dvec2 st) {
    const dvec3 r = reflected(st);
    const Color wall = mix({0.1, 0.11, 0.14}, {0.3, 0.31, 0.35}, ramp(-0.2, 0.8, r.y));
    const Color floor = mix({0.26, 0.2, 0.15}, {0.1, 0.08, 0.07}, ramp(-0.05, -0.9, r.y));
    const Color room = mix(floor, wall, ramp(-0.12, -0.08, r.y));
    return room + Color(1, 0.98, 0.94) * soft_box(r) + Color(0.8, 0.92, 1) * window(r) +
           Color(1, 0.85, 0.6) * lamps(r);
}

Color landscape(dvec2 st) {
    const dvec3 r = reflected(st);
    const Color sky = mix({0.82, 0.88, 0.94}, {0.2, 0.4, 0.75}, ramp(0, 0.8, r.y));
    const Color ground = mix({0.42, 0.38, 0.26}, {0.16, 0.13, 0.09}, ramp(0, -0.8, r.y));
    const double hills = 0.1 * noise({0.5 + 0.5 * r.x, r.z > 0 ? 0.25 : 0.75}, {6, 2}, 601);
    const Color land = mix(ground, {0.2, 0.28, 0.22}, ramp(-0.02, 0.02, r.y));
    const double sun = ramp(0.985, 0.99, glm::dot(r, glm::normalize(dvec3(-0.5, 0.6, 0.62))));
    return mix(land, sky, ramp(hills - 0.01, hills + 0.01, r.y)) + Color(1, 0.95, 0.8) * sun;
}

}  // namespace gw::maps
