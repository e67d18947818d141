// Vessels turned on a lathe: profiles of cubic Bezier curves and straight lines, revolved.
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
using Profile = std::vector<ProfileCurve>;

/// `segments` rows of triangles on each curve, one on each line; edges are sharp between curves
/// that meet at an angle. s once round, t along the profile by its length.
MeshData make_lathe(const Profile& profile, int slices, int segments);

/// Profiles drawn for our scenes. All are 1 high and stand on y = 0.
Profile bottle_profile();
Profile bowl_profile();
Profile goblet_profile();
Profile pedestal_profile();  ///< a round column with base and plate, solid
Profile vase_profile();

}  // namespace gw::scene
