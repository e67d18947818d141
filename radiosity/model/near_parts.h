// Parts of a patch beside surfaces that nothing hides from them, as in the corner of a room. The
// form factors of the texels there need no hemicube. Does not compute them (near_texels.h does).
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <optional>
#include <vector>

namespace gw::radiosity {

/// A rectangle in a pixmap.
struct Part {
    dvec2 low, high;
    double area() const { return (high.x - low.x) * (high.y - low.y); }
};

/// Texels of a facet that are near to a part.
struct NearTexels {
    std::uint32_t facet = 0;
    ivec2 first{0}, end{0};    ///< columns and rows
    std::vector<dvec3> sides;  ///< only p with dot(side, (1, u, v)) >= 0 are seen from the part

    bool contains(int u, int v) const {
        return u >= first.x && u < end.x && v >= first.y && v < end.y;
    }
};

struct NearPart {
    std::uint32_t facet = 0;  ///< that covers the part
    Part part;
    double share = 0;  ///< of the patch's area
    std::vector<NearTexels> texels;
};

/// For a part that is covered by a facet: the texels within `reach` of its middle. None if another
/// surface may hide one of them, or light passes beside them: then the points must be closer.
std::optional<NearPart> near_part_of(const PixmapModel& model, std::uint32_t facet,
                                     const Part& part, double reach);

}  // namespace gw::radiosity
