// I_raytracing(x, y) of eq. 5 [K4]: at every pixel, the ray from the eye meets the plane of the
// item buffer's polygon, without a search. The light that this polygon reflects and transmits is
// traced from there [K4i]; pixels whose polygon does neither are not traced. Does not draw and does
// not add.
#pragma once

#include "gw/profile.h"
#include "raytrace/tracer/tracer.h"

#include <cstdint>
#include <vector>

namespace gw::itembuffer {

struct TracedComponent {
    /// Through the first hit's black fog [K3.5]; alpha is 0.
    std::vector<Rgba> color;
    raytrace::RayCounts counts;  ///< primary: rays cut with their one polygon, one triangle each
};

/// `ids` and `jitter` are the item buffer's. Vertices are snapped before the machine fills a
/// polygon, so a pixel's centre may lie a little outside the true polygon. Its plane extends there;
/// weights of texture coordinates and normals end at the border.
TracedComponent traced_component(const raytrace::Tracer& tracer, const scene::Scene& scene,
                                 const scene::View& view, const std::vector<std::uint32_t>& ids,
                                 const JitterState& jitter, const Profile& profile);

}  // namespace gw::itembuffer
