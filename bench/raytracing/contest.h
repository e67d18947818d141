// One scene drawn by eq. 5 and by the ordinary ray tracer, on one thread, timed. [K4f]
#pragma once

#include "raytrace/tracer/tracer.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>

namespace gw::bench {

inline constexpr int width = 640, height = 480;

struct Contest {
    /// processor seconds of a frame: passes, item buffer, traced component; without data that are
    /// independent of the view (hierarchy, shadow volumes)
    double item_buffer = 0;
    double traced = 0;            ///< of these, the item buffer and the traced component
    double item_buffer_maps = 0;  ///< a frame whose reflected hits read earlier shadow maps
    double maps_drawn = 0;        ///< to draw these maps, once for all views
    double ray_tracing = 0;       ///< of the ordinary ray tracer's frame
    double hierarchy = 0;         ///< to build it: both need it, and no figure above includes it
    double share = 0;             ///< of pixels that are traced: g
    std::size_t triangles = 0;
    raytrace::RayCounts item_buffer_rays, ray_tracing_rays;
    double maps_differ = 0;  ///< of pixels, by more than 2 of 255 from those with shadow rays
    double maps_error = 0;   ///< mean over pixels and channels, in units of 255

    double gain() const { return ray_tracing / item_buffer; }
    double gain_maps() const { return ray_tracing / item_buffer_maps; }
    /// 1 + 1 / g: the passes free, and exact shadow rays.
    double bound() const { return 1 + 1 / share; }
};

/// Best of `runs`; `samples` pictures each.
Contest contest(const scene::Scene& scene, int samples, int runs);

}  // namespace gw::bench
