// An octree of a scene's polygons in the world: each in the smallest cube that has all of it. Does
// not project.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <array>
#include <memory>

namespace gw::hiddensurface {

struct Cube {
    dvec3 low{0}, high{0};
    /// across the middle planes, or few: not in a part
    std::vector<std::size_t> polygons;
    /// bit 0: the upper half in x, bit 1: y, bit 2: z
    std::array<std::unique_ptr<Cube>, 8> parts;
};

/// Of the polygons in the window; none: null. Cubes of at most `few` polygons are not divided.
std::unique_ptr<Cube> build_octree(const std::vector<Polygon>& polygons, std::size_t few = 8);

/// The parts in an order in which none is before an earlier one, for an eye (P_E, 1) or (direction
/// to it, 0).
std::array<std::size_t, 8> near_to_far(const Cube& cube, const dvec4& eye);

/// The pixels that a box of the world may cover, and the nearest depth it may have, in units of the
/// depth plane.
struct WindowBox {
    Rect rect;
    std::int64_t nearest = 0;
};
/// Not known where the box reaches before the near plane: everything in the window, as near as can
/// be.
WindowBox window_box(const dvec3& low, const dvec3& high, const scene::View& view,
                     const Profile& profile);

}  // namespace gw::hiddensurface
