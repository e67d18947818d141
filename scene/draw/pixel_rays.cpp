#include "scene/draw/pixel_rays.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace gw::scene {

PixelRays::PixelRays(const View& view)
    : world_from_clip_(glm::inverse(view.clip_from_eye * view.eye_from_world)),
      width_(view.width),
      height_(view.height) {}

PixelRay PixelRays::through(double x, double y) const {
    const auto at = [&](double z) {
        const dvec4 p = world_from_clip_ * dvec4(2 * x / width_ - 1, 2 * y / height_ - 1, z, 1);
        return dvec3(p) / p.w;
    };
    const dvec3 o = at(-1);
    return {o, at(1) - o};
}

dvec2 place_in_pixel(const JitterState& jitter, int subpixel_bits) {
    const double unit = std::ldexp(1.0, -subpixel_bits);
    return {0.5 - jitter.x * unit, 0.5 - jitter.y * unit};
}

}  // namespace gw::scene
