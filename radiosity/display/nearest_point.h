// The point of the figures that is nearest to a point in the world. Does not draw.
#pragma once

#include "radiosity/model/pixmap_model.h"

namespace gw::radiosity {

struct SurfacePoint {
    std::uint32_t facet = no_facet;
    dvec2 uv{0};  ///< texel coordinates in the facet's pixmap
    double distance = 0;
};

/// Of several at one distance, the first. Precondition: the model has a facet.
SurfacePoint nearest_point(const PixmapModel& model, const dvec3& p);

}  // namespace gw::radiosity
