// The ordinary ray tracer [L9]: a ray from the eye through every pixel, the nearest of all
// triangles, eq. 3 with shadow rays, and the rays that follow. The baseline of eq. 5 [K4f]. Does
// not superpose pictures.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "raytrace/tracer/tracer.h"

#include <cstdint>
#include <vector>

namespace gw::raytrace {

/// Bottom row first.
struct RaytracedPicture {
    /// as a frame buffer of the profile holds it: clamped, to nearest
    std::vector<Rgba> color;
    std::vector<std::uint32_t> ids;  ///< of the polygon seen; 0: the background
    RayCounts counts;
};

/// `jitter` moves the scene as the machine does [K4a]. Fog is that of the first hit, at its own
/// distance.
RaytracedPicture raytraced_picture(const Tracer& tracer, const scene::Scene& scene,
                                   const scene::View& view, const JitterState& jitter,
                                   const Profile& profile);

/// The picture as a pixel rectangle, all tests off.
CommandList commands(const RaytracedPicture& picture, const scene::View& view);

/// The light that a surface sends to the eye: eq. 3, the traced component, and fog. A translucent
/// surface is blended over the surface behind it [K3.4].
dvec3 seen_color(const Tracer& tracer, const Surface& surface, const scene::Scene& scene,
                 const Profile& profile, RayCounts& counts);

/// The part of the light that passes the scene's fog from this eye-space point, 0 .. 1.
double seen_through_fog(const scene::Scene& scene, const dvec3& p_eye, const Profile& profile);

/// Calls body(x, y, counts) for every pixel of the view's rows on `threads` threads and sums the
/// counts. Square by square: neighbouring rays meet the same nodes.
RayCounts for_pixels(const scene::View& view, int threads,
                     const std::function<void(int, int, RayCounts&)>& body);

/// A colour as a frame buffer holds it: clamped, to nearest; alpha full.
Rgba stored(const dvec3& color, int bits);

}  // namespace gw::raytrace
