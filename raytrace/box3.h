// Axis-aligned boxes of float32. Empty until something is added.
#pragma once

#include "gw/types.h"

#include <algorithm>
#include <limits>

namespace gw::raytrace {

struct Box3 {
    vec3 low{std::numeric_limits<float>::infinity()};
    vec3 high{-std::numeric_limits<float>::infinity()};

    void add(const vec3& p) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    void add(const Box3& b) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], b.low[k]);
            high[k] = std::max(high[k], b.high[k]);
        }
    }
    /// Half the surface; 0 of an empty one.
    float area() const {
        const vec3 e(high.x - low.x, high.y - low.y, high.z - low.z);
        return e.x < 0 ? 0 : (e.x * e.y + e.y * e.z) + e.z * e.x;
    }
};

}  // namespace gw::raytrace
