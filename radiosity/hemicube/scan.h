// From the pixels of an ID buffer to texels [F2.2]: each texel's share of the light of a point.
// Does not draw the buffers and knows no energy.
#pragma once

#include "radiosity/hemicube/hemicube.h"
#include "radiosity/model/pixmap_model.h"

#include <span>

namespace gw::radiosity {

struct ScanOptions {
    /// Pixels larger than a texel are divided [F2.2o] into at most this many parts each way. If it
    /// is 1, no pixel is divided, and each goes to the one texel under its middle (Fig. 3a).
    int most_parts = 64;
};

/// Adds to factors[texel] the delta form factors of the pixels that see `pixmap`; returns those
/// that see backs of its figures. `factors` are those of the whole model; only those of this pixmap
/// are touched, so pixmaps can be scanned in parallel [F2.2p].
double scan_pixmap(const PixmapModel& model, std::uint32_t pixmap, const Hemicube& hemicube,
                   const IdBuffers& buffers, const DeltaFormFactors& delta,
                   const ScanOptions& options, std::span<double> factors);

/// The delta form factors of pixels that see nothing.
double escaping(const IdBuffers& buffers, const DeltaFormFactors& delta);

}  // namespace gw::radiosity
