// The facets of a model as convex pieces of planes, whose texels can be computed one by one [F2.1].
// Depends on no hemicube.
#pragma once

#include "radiosity/model/geometry.h"
#include "radiosity/model/pixmap_model.h"

#include <optional>
#include <vector>

namespace gw::radiosity {

/// The convex hull of a facet. It may cover more than the facet: there, the ID buffers show another
/// one.
struct PlaneFigure {
    static constexpr std::size_t most_corners = 8;

    /// A texel that is not wholly inside the hull.
    struct Cut {
        int u = 0, v = 0;
        dvec2 middle{0};   ///< of the part inside
        double share = 0;  ///< inside; may be 0
    };
    std::uint32_t facet = 0;
    std::vector<dvec2> outline;  ///< in texels, counterclockwise, at most most_corners
    ivec2 first{0}, end{0};      ///< texels that it touches, columns and rows
    std::vector<Cut> cuts;       ///< of these, row by row
    /// of a sphere around Facet::center that contains the facet's bounds in texels
    double radius = 0;

    int width() const { return end.x - first.x; }
};

/// By facet; none if the hull has too many corners.
std::vector<std::optional<PlaneFigure>> plane_figures(const PixmapModel& model);

/// The part of a texel that is inside the hull.
Polygon2 part_in_texel(const PlaneFigure& figure, int u, int v);

}  // namespace gw::radiosity
