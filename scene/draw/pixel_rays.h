// Rays through the pixels of a view, world space. Does not intersect them with anything.
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

/// The point of a pixel, from its corner, through which its ray of a jittered picture passes. The
/// machine moves the scene by the jitter, so the ray moves the opposite way.
dvec2 place_in_pixel(const JitterState& jitter, int subpixel_bits);

}  // namespace gw::scene
