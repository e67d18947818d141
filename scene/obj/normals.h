// Generates normals for corners without one: smooth across faces of one smoothing group, or within
// a crease angle. Does not change normals of the file.
#pragma once

#include "scene/obj/obj_data.h"

namespace gw::scene {

inline constexpr double default_crease = 60;  ///< degrees

/// Faces at one point are compared with each other up to this number.
inline constexpr std::size_t most_compared = 1024;

/// Appends normals to obj.normals and names them in the corners of faces that have none, or one of
/// length 0. At each corner the normal is a sum of area vectors, divided by its length. The sum is
/// over the faces that meet there (at bit-equal positions) and are smooth with the corner's own
/// face, in the order of the file. Two faces are smooth together if both are in the same smoothing
/// group, or if both are smooth_by_angle and their normals differ by at most `crease` degrees. A
/// face without area takes the sum of all faces that meet there; if that is 0 too, (0, 0, 1). Where
/// more than most_compared faces meet that are not one smooth surface, those smooth_by_angle stay
/// flat. Returns one of them; null: there is none.
const Element* add_normals(ObjData& obj, double crease);

}  // namespace gw::scene
