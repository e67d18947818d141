// The rays that a view's pixels look along, world space. Does not know what they meet.
#pragma once

#include "gw/state.h"
#include "scene/draw/view.h"

namespace gw::scene {

/// From the near plane (t = 0) to the far plane (t = 1).
struct PixelRay {
    dvec3 o{0}, d{0};
};

class PixelRays {
public:
    explicit PixelRays(const View& view);

    /// Through a window position: pixel (i, j) has its centre at (i + 1/2, j + 1/2).
    PixelRay through(double x, double y) const;

private:
    dmat4 world_from_clip_;
    double width_, height_;
};

/// Where in its pixel a ray of a jittered picture goes through: the machine moves the scene by the
/// jitter, so that a pixel's centre sees what lies as much the other way.
dvec2 place_in_pixel(const JitterState& jitter, int subpixel_bits);

}  // namespace gw::scene
