// From where the positions of an OBJ file's parts count. Positions become float32 relative to a
// point near them, so that map coordinates keep their digits (scene/geometry/far.h).
#pragma once

#include "scene/obj/obj_data.h"
#include "scene/text/warnings.h"

#include <vector>

namespace gw::scene {

/// A point for each part; none: all count from 0, as float32 values do. Most parts share one, so
/// that faces which meet have equal corners. A part that lies very far from it for its size has
/// another.
std::vector<dvec3> origins_of_parts(const ObjData& obj);

/// Warns of a part that lies in several places: its faces lose digits wherever they count from.
void warn_rounded(const ObjData& obj, Warnings& warnings);

}  // namespace gw::scene
