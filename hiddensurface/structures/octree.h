// An octree of a scene's polygons in the world: each is in the smallest cube around it. Does not
// draw.
#pragma once

#include "hiddensurface/model/polygon.h"

#include <array>
#include <memory>

namespace gw::hiddensurface {

struct Cube {
    dvec3 low{0}, high{0};
    /// polygons across the middle planes; all, if the cube has only few
    std::vector<std::size_t> polygons;
    /// bit 0: the upper half in x, bit 1: y, bit 2: z
    std::array<std::unique_ptr<Cube>, 8> parts;
};

/// The tree of the polygons in the window; null if there are none. Cubes of at most `few` polygons
/// are not divided.
std::unique_ptr<Cube> build_octree(const std::vector<Polygon>& polygons, std::size_t few = 8);

/// The parts in an order in which a later one never hides an earlier one, for an eye (P_E, 1) or
/// (direction to it, 0).
std::array<std::size_t, 8> near_to_far(const Cube& cube, const dvec4& eye);

/// The pixels that a box of the world may cover, and the nearest depth it may have, in units of the
/// depth plane.
struct WindowBox {
    Rect rect;
    std::int64_t nearest = 0;
};
/// A box that reaches before the near plane counts as the whole window at depth 0.
WindowBox window_box(const dvec3& low, const dvec3& high, const scene::View& view,
                     const Profile& profile);

}  // namespace gw::hiddensurface
