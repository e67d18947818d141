// A scene's polygons in view: in the world as given, and on the window grid as the machine draws
// them. Every algorithm decides on these, so all agree with the machine's pixels. Does not hide
// anything.
#pragma once

#include "gw/profile.h"
#include "gw/state.h"
#include "hiddensurface/model/grid.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <string>

namespace gw::hiddensurface {

/// A triangle as the machine fills it: decomposed, clipped, snapped. A scene's triangles in order are
/// the machine's own.
struct WindowTriangle {
    std::array<GridPoint, 3> corners;
    DepthPlane depth;
    std::uint32_t source = 0;  ///< ordinal of the mesh's triangle it was cut from
};

/// A plane piece of a polygon on the grid: consecutive triangles. The snap bends a polygon of more
/// than three corners. Then every triangle is a facet of its own, which is exactly in its plane.
struct Facet {
    std::vector<Loop> parts;  ///< convex
    /// (-dz/dx, -dz/dy, 1, d): `side` is a point's distance behind it in units of the depth plane;
    /// before it (nearer to the eye) is negative.
    dvec4 plane{0, 0, 1, 0};
    std::size_t first = 0, count = 0;  ///< of the polygon's triangles
};

/// A plane piece of a polygon in the world: the polygon, or if its corners are not in one plane, a
/// triangle that the machine draws.
struct WorldFacet {
    std::vector<Loop> parts;             ///< convex
    std::uint32_t first = 0, count = 0;  ///< ordinals of the mesh's triangles
};

struct Polygon {
    std::uint32_t id = 0;    ///< of the item buffer: 1, 2, ...; 0 is the background
    std::size_t object = 0;  ///< of the scene
    Loop world;              ///< corners as given, world space
    std::vector<WorldFacet> world_facets;
    /// Clipped and snapped; none: the polygon is outside the window.
    std::vector<WindowTriangle> triangles;
    std::vector<Facet> facets;
    /// Least and greatest distance of its corners along the line of sight, and that of their mean.
    double nearest = 0, farthest = 0, centroid = 0;

    bool visible() const { return !triangles.empty(); }
};

/// The name of a polygon in step logs: its identifier; of part k of several plane parts: "3.1", ...
inline std::string name_of(const Polygon& polygon, std::size_t part = 0, std::size_t parts = 1) {
    const std::string name = std::to_string(polygon.id);
    return parts < 2 ? name : name + "." + std::to_string(part + 1);
}

/// All polygons of a scene, also those outside the window, in the order in which the machine draws
/// them. The jitter moves the snapped corners, as on the machine.
std::vector<Polygon> project(const scene::Scene& scene, const scene::View& view,
                             const Profile& profile, const JitterState& jitter = {});

/// (P_E, 1), or (the direction towards the eye, 0) if all lines of sight are parallel.
dvec4 eye_of(const scene::View& view);

/// The same with a direction of length 1, so that a product with it is a length: for step logs.
dvec4 unit_eye_of(const scene::View& view);

/// Whether the eye is on the side that a world plane's normal points to.
bool is_before(const dvec4& world_plane, const scene::View& view);

/// The world plane (n, d) on the window grid, with the same sign at every point before the eye.
dvec4 to_window(const dvec4& world_plane, const scene::View& view, const Profile& profile);

}  // namespace gw::hiddensurface
