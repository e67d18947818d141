// A scene whose BSP tree is one chain. Does not draw.
#pragma once

#include "gw/base/elementary.h"
#include "tests/hiddensurface/cases.h"

namespace gw::hiddensurface {

/// The upright sides of a prism over a regular polygon, seen from above.
inline scene::Scene prism(int sides) {
    MeshData data{.primitive = Primitive::Quads};
    const auto corner = [sides](int k, float z) {
        const double angle = 360.0 * (k % sides) / sides;
        return vec3(float(cos_degrees(angle)), float(sin_degrees(angle)), z);
    };
    for (int k = 0; k < sides; ++k)
        for (const vec3& p : {corner(k, 0), corner(k + 1, 0), corner(k + 1, 1), corner(k, 1)})
            data.positions.push_back(p);
    return polygon_scene(std::move(data));
}

}  // namespace gw::hiddensurface
