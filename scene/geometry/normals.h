// Normals for the corners that have none: smooth across faces of one smoothing group, or within a
// crease angle. Does not touch normals that the file gives.
#pragma once

#include "scene/obj/obj_data.h"

namespace gw::scene {

inline constexpr double default_crease = 60;  ///< degrees

/// Appends normals to obj.normals and names them in the corners of faces that have none, or one of
/// length 0.
/// At each corner: the sum of the area vectors of the faces that meet there (at bit-equal
/// positions) and are smooth with the corner's own face, in the order of the file, divided by its
/// length. Two faces are smooth together when both are in the same smoothing group, or both are
/// smooth_by_angle and their normals differ by at most `crease` degrees. A face without area takes
/// the sum of all faces that meet there; where that is 0 too, (0, 0, 1).
void add_normals(ObjData& obj, double crease);

}  // namespace gw::scene
