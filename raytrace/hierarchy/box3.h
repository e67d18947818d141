// Axis-aligned boxes of float32. Corners have four numbers, so that the compiler uses vectors; the
// fourth has no meaning. Empty until something is added. Does not intersect rays (search.cpp).
#pragma once

#include "gw/base/types.h"

#include <limits>

namespace gw::raytrace {

struct alignas(16) Box3 {
    float low[4], high[4];

    Box3() {
        for (int k = 0; k < 4; ++k) {
            low[k] = std::numeric_limits<float>::infinity();
            high[k] = -std::numeric_limits<float>::infinity();
        }
    }
    void add(const vec3& p) {
        for (int k = 0; k < 3; ++k) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
    void add(const Box3& b) {
        for (int k = 0; k < 4; ++k) {
            low[k] = b.low[k] < low[k] ? b.low[k] : low[k];
            high[k] = b.high[k] > high[k] ? b.high[k] : high[k];
        }
    }
    /// Half the surface; 0 of an empty one.
    float area() const {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x < 0 ? 0 : (x * y + y * z) + z * x;
    }
};

}  // namespace gw::raytrace
