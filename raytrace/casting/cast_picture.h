// A picture by ray casting as it is taught [L9]: the nearest shape of every pixel, eq. 3 with the
// shape's own normal. No maps, shadows or reflections: it shows the number of tests that a pixel
// costs.
#pragma once

#include "raytrace/casting/casting.h"
#include "scene/draw/view.h"

#include <cstdint>
#include <vector>

namespace gw::raytrace {

/// Bottom row first.
struct CastPicture {
    std::vector<Rgba> color;           ///< 8 bits
    std::vector<std::uint32_t> tests;  ///< of each pixel: shapes, boxes and voxels
    CastCounts counts;
};

/// The same for any number of threads (0: all): pixels are dealt out row by row [L12].
CastPicture cast_picture(const RayCaster& caster, const std::vector<CastShape>& shapes,
                         const scene::Scene& scene, const scene::View& view, int threads);

}  // namespace gw::raytrace
