// The pixels of an ID buffer that a facet can be in: the region spanned by its corners [F2.2].
// A corner may lie behind the face; the region is clipped before it is projected.
#pragma once

#include "radiosity/hemicube/hemicube.h"

#include <optional>

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

/// Rows are those of the face's IdBuffer. `region` is overwritten; empty where the facet is not
/// before the face.
void find_region(const Facet& facet, const scene::View& view, bool top, Region& region);

}  // namespace gw::radiosity
