// An axis-aligned box in double, and a ray through it: the lecture's bounding volume [L12]. box3.h
// is the fast hierarchy's, in float32.
#pragma once

#include "raytrace/casting/ray.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace gw::raytrace {

struct Box {
    dvec3 low{std::numeric_limits<double>::infinity()},
        high{-std::numeric_limits<double>::infinity()};

    void add(const dvec3& p) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    void add(const Box& b) {
        add(b.low);
        add(b.high);
    }
};

/// Where the ray is in the box, cut at t = 0. Slabs; parallel to one it is inside or not. The box
/// is taken a little larger, so that rounding loses nothing that lies in its faces.
struct Interval {
    double from = 0, to = 0;
};
inline std::optional<Interval> through(const Box& box, const Ray& ray) {
    Interval in{0, std::numeric_limits<double>::infinity()};
    for (int k = 0; k < 3; ++k) {
        const double slack =
            1e-12 * (std::max(std::abs(box.low[k]), std::abs(box.high[k])) + 1e-300);
        const double low = box.low[k] - slack, high = box.high[k] + slack;
        if (ray.direction[k] == 0) {
            if (ray.origin[k] < low || ray.origin[k] > high) return std::nullopt;
            continue;
        }
        const double a = (low - ray.origin[k]) / ray.direction[k],
                     b = (high - ray.origin[k]) / ray.direction[k];
        in.from = std::max(in.from, std::min(a, b));
        in.to = std::min(in.to, std::max(a, b));
    }
    if (in.from > in.to * (1 + 1e-12)) return std::nullopt;
    return in;
}

}  // namespace gw::raytrace
