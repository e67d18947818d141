// Surfaces of revolution about the y axis, and vessels turned on a lathe: profiles of cubic Bezier
// curves and straight lines, revolved.
#pragma once

#include "gw/mesh.h"

#include <vector>

namespace gw::scene {

/// A curve from `from`; a straight line if `straight` (then its control points are unused).
struct ProfileCurve {
    dvec2 from, control1, control2, to;
    bool straight = false;
};

/// Curves end to end, outside to their right, starting and ending on the axis.
using LatheProfile = std::vector<ProfileCurve>;

/// `segments` rows of triangles on each curve, one on each line; edges are sharp between curves
/// that meet at an angle. s once round, t along the profile by its length.
MeshData make_lathe(const LatheProfile& profile, int slices, int segments);

/// Profiles drawn for our scenes. All are 1 high and stand on y = 0.
LatheProfile bottle_profile();
LatheProfile bowl_profile();
LatheProfile goblet_profile();
LatheProfile pedestal_profile();  ///< a round column with base and plate, solid
LatheProfile vase_profile();

/// A point of the profile curve: (distance from the axis, height).
struct ProfilePoint {
    dvec2 position;
    dvec2 normal;  ///< to the right of the curve's direction, any length
    double t;      ///< texture coordinate along the curve
};

/// Turns a profile in steps of 360 / slices degrees. The curve runs so that outside is to its
/// right: bottom, up along the outside, down along the inside. s runs once round, from z, over x,
/// in steps of 1 / slices. At a point on the axis it lies between its triangle's two others.
MeshData revolve(const std::vector<ProfilePoint>& profile, int slices);

}  // namespace gw::scene
