// A ray: P = E t + P_E [L9]. Does not intersect.
#pragma once

#include "gw/base/types.h"

namespace gw::raytrace {

struct Ray {
    dvec3 origin{0};     ///< P_E
    dvec3 direction{0};  ///< E; of any length but 0: t counts in its lengths
};

inline dvec3 point_at(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

}  // namespace gw::raytrace
