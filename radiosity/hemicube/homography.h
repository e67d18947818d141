// From the pixels of a face to texel coordinates [F2.2]: a plane seen in perspective, so one
// homography for a facet and a face.
#pragma once

#include "radiosity/hemicube/hemicube.h"

namespace gw::radiosity {

/// Texel coordinates of pixels: (u, v) = (U, V) / W, each linear in the pixel's coordinates. W is
/// below 0 where the facet's front is seen.
struct Homography {
    dvec3 at_zero{0}, along_x{0}, along_y{0};  ///< of U, V, W
};

/// `first_row`: of the face's IdBuffer in its window.
Homography homography(const Facet& facet, const Hemicube& hemicube, const scene::View& view,
                      int first_row);

}  // namespace gw::radiosity
