// A facet in one face of a hemicube [F2.2]: the pixels that it can be in, and the map from pixels to
// its texel coordinates. Does not look at the pixels (scan.h does).
#pragma once

#include "radiosity/hemicube/hemicube.h"

#include <vector>

namespace gw::radiosity {

/// Pixels first .. end - 1 of each row from `row` on; wider by a pixel than the exact region on all
/// sides.
struct Region {
    struct Span {
        int first = 0, end = 0;
    };
    int row = 0;
    std::vector<Span> spans;
};

/// Rows are those of the face's IdBuffer. `region` is overwritten; empty if the facet is not in
/// front of the face.
void find_region(const Facet& facet, const scene::View& view, bool top, Region& region);

/// Texel coordinates of pixels: (u, v) = (U, V) / W, each linear in the pixel's coordinates. W is
/// negative if the facet's front is seen.
struct Homography {
    dvec3 at_zero{0}, along_x{0}, along_y{0};  ///< of U, V, W
};

/// `first_row`: of the face's IdBuffer in its window.
Homography homography(const Facet& facet, const Hemicube& hemicube, const scene::View& view,
                      int first_row);

}  // namespace gw::radiosity
