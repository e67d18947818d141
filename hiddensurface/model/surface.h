// What lies under a pixel of a polygon: position, normal and texture coordinates in perspective,
// from the ray through the pixel's centre. Does not shade.
#pragma once

#include "hiddensurface/model/polygon.h"
#include "scene/draw/shading.h"

namespace gw::hiddensurface {

/// The triangles of a scene's objects before the eye.
class Surfaces {
public:
    Surfaces(const scene::Scene& scene, const scene::View& view);

    /// The point of the triangle that the ray through `p`, in pixels, meets; beyond its border by
    /// rounding, the nearest point. `front`: which side is seen, by the triangle's winding in the
    /// window.
    scene::SurfacePoint at(std::size_t object, std::uint32_t triangle, const dvec2& p,
                           bool front) const;

private:
    struct Placed {
        const Mesh* mesh = nullptr;
        std::vector<dvec3> p_eye, n_eye;
    };
    struct Sight {
        dvec3 origin, direction;
    };
    Sight sight(double x, double y) const;

    const scene::View& view_;
    std::vector<Placed> placed_;
};

/// Counter-clockwise in the window: its front is seen.
bool is_front(const WindowTriangle& triangle);

}  // namespace gw::hiddensurface
