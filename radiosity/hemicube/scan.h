// From the pixels of an ID buffer to texels [F2.2]: each texel's share of the light of a point.
// Does not draw the buffers and knows no energy.
#pragma once

#include "radiosity/hemicube/footprints.h"
#include "radiosity/hemicube/hemicube.h"
#include "radiosity/model/pixmap_model.h"

#include <span>
#include <vector>

namespace gw::radiosity {

struct ScanOptions {
    /// Pixels larger than a texel are divided [F2.2o] into at most this many parts each way. If it
    /// is 1, no pixel is divided, and each goes to the one texel under its middle (Fig. 3a).
    int most_parts = 64;
    /// Facets that are large in the faces are computed texel by texel (texel_scan.h), the others by
    /// pixels. If false, or most_parts is 1, all are computed by pixels.
    bool texels = true;
};

/// Memory for one scan at a time.
struct PixelScratch {
    /// A pixel that is divided: which of `pixels`, and its parts in `parts`.
    struct Divided {
        std::size_t pixel, first, end;
    };
    Region region;
    FacetPixels pixels;  ///< of one row ...
    Boxes row;           ///< ... and their footprints
    Parts parts;
    std::vector<Divided> divided;
    Boxes boxes;
};

/// Adds to factors[texel] the delta form factors of the pixels that see a facet's front; returns
/// those that see its back. `factors` are those of the whole model; only those of the facet's pixmap
/// are touched, so pixmaps can be scanned in parallel [F2.2p].
double scan_pixels(const PixmapModel& model, std::uint32_t facet, const Hemicube& hemicube,
                   const IdBuffers& buffers, const DeltaFormFactors& delta,
                   const ScanOptions& options, std::span<double> factors, PixelScratch& scratch);

/// The delta form factors of pixels that see nothing.
double escaping(const IdBuffers& buffers, const DeltaFormFactors& delta);

}  // namespace gw::radiosity
