// Adaptive sampling on one item buffer [K4a], which the paper warns of. A pixel whose eight
// neighbours show the same polygon gets one ray; any other pixel gets several. They are cut with
// the polygons that the item buffer has in these nine pixels. So it misses polygons smaller than a
// pixel, and needles (Fig. 7), which several item buffers find (Fig. 8). Does not superpose
// pictures.
#pragma once

#include "gw/machine.h"
#include "itembuffer/render.h"
#include "raytrace/tracer/render.h"

#include <cstdint>
#include <vector>

namespace gw::itembuffer {

struct AdaptivePicture {
    raytrace::RaytracedPicture picture;  ///< primary: rays cut with the item buffer's polygons
    std::vector<std::uint8_t> divided;   ///< 1: the pixel got `samples` rays
};

/// `ids`: the item buffer of the view, without jitter. First hits are shaded by eq. 3 with shadow
/// rays, then traced.
AdaptivePicture adaptive_picture(const raytrace::Tracer& tracer, const scene::Scene& scene,
                                 const scene::View& view, const std::vector<std::uint32_t>& ids,
                                 int samples, const Profile& profile);

/// Leaves the picture in the machine's colour plane.
void render_adaptive(Machine& machine, const scene::Scene& scene, const scene::View& view,
                     int samples, const Options& options);

}  // namespace gw::itembuffer
