// A scene's polygons in view: in the world as they are given, and on the machine's window grid as it draws
// them. Every algorithm decides on these, so all agree with the machine's pixels. Does not hide anything.
#pragma once

#include "gw/profile.h"
#include "hiddensurface/depth_plane.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace gw::hiddensurface {

/// A triangle as the machine fills it: decomposed, clipped, snapped. Those of a scene in order are the
/// machine's own, piece by piece.
struct WindowTriangle {
    std::array<GridPoint, 3> corners;
    DepthPlane depth;
    std::uint32_t source = 0;  ///< ordinal of the mesh's triangle it was cut from
};

struct Polygon {
    std::uint32_t id = 0;           ///< of the item buffer: 1, 2, ...; 0 is the background
    std::size_t object = 0;         ///< of the scene
    Loop world;                     ///< corners as given, world space
    std::vector<Loop> world_parts;  ///< convex, together the polygon: itself, or its triangles
    /// Clipped and snapped; none: nothing of it is in the window. `parts` are convex up to the snap.
    std::vector<WindowTriangle> triangles;
    std::vector<Loop> parts;
    /// Least and greatest distance of its corners along the line of sight, and of their mean.
    double nearest = 0, farthest = 0, centroid = 0;
    /// (n, d) on the window grid, z growing away from the eye, n.z >= 0: points before the plane (nearer to
    /// the eye) are negative.
    dvec4 plane{0, 0, 0, 0};
    /// How far its own corners are from its plane (the snap bends a quadrilateral; triangles are exact), and
    /// a thousandth of a unit for rounding; times |n|, as `side` measures. Nearer than this is on the plane.
    double tolerance = 0;

    bool visible() const { return !triangles.empty(); }
};

/// All polygons of a scene in the order in which the machine draws them; those outside the window too.
std::vector<Polygon> project(const scene::Scene& scene, const scene::View& view, const Profile& profile);

/// The world plane (n, d) on the window grid, same sign at every point before the eye.
dvec4 to_window(const dvec4& world_plane, const scene::View& view, const Profile& profile);

}  // namespace gw::hiddensurface
