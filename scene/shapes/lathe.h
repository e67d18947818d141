// Turned vessels: a profile of cubic Bezier curves and straight lines, revolved. The profiles are
// in profiles.h.
#pragma once

#include "gw/mesh.h"

#include <vector>

namespace gw::scene {

/// A curve from `from`; a straight line where `straight` (then its control points are not used).
struct ProfileCurve {
    dvec2 from, control1, control2, to;
    bool straight = false;
};

/// Curves end to end, outside to their right, starting and ending on the axis.
using Profile = std::vector<ProfileCurve>;

/// `segments` rows of triangles on each curve, one on each line; edges are sharp where two curves
/// meet at an angle. s once round, t along the profile by its length.
MeshData make_lathe(const Profile& profile, int slices, int segments);

}  // namespace gw::scene
