// A figure's light from a point, texel by texel [F2.2]: form factors in closed form, and from the ID
// buffers what of each texel is seen. Plane figures, and the pieces of curved ones. Facets that this
// does not serve are scanned by pixels (scan.h).
#pragma once

#include "radiosity/hemicube/texel_rows.h"
#include "radiosity/model/pieces.h"

#include <span>

namespace gw::radiosity {

/// Memory for one scan at a time.
struct TexelScratch {
    std::vector<float> low, high;             ///< corners of a row's texels
    std::vector<TexelKind> kinds;             ///< of a row
    std::vector<float> factors;               ///< of PlaneFigure::first .. end
    std::array<TexelList, near_point> lists;  ///< by kind
    std::vector<ivec2> near;
};

/// Whether a figure's front is turned to the point and large enough in the faces: of few pixels, or
/// narrow ones, the buffers do not tell which part is seen.
bool can_scan_texels(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube);

/// Adds to factors[texel] the light of each texel of the figure. `factors` are those of the whole
/// model. Returns whether any light was found. The figure's front is turned to the point.
bool scan_texels(const PixmapModel& model, const PlaneFigure& figure, const Hemicube& hemicube,
                 const SeenIds& seen, std::span<double> factors, TexelScratch& scratch);

/// Whether a facet's front is turned to the point, and so far away that its pieces' form factors are
/// those of small areas.
bool can_scan_pieces(const PixmapModel& model, std::uint32_t facet, const Hemicube& hemicube);

/// Adds to factors[texel] the light of each piece of a facet, seen or not as its middle is. The
/// buffers need not show the facet: of its figure they show some facet there.
void scan_pieces(const PixmapModel& model, std::uint32_t facet, std::span<const Piece> pieces,
                 const Hemicube& hemicube, const SeenIds& seen, std::span<double> factors);

/// The same bits on every processor: eight sums, then theirs.
double sum_of(std::span<const double> values);

}  // namespace gw::radiosity
