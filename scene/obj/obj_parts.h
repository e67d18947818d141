// From OBJ statements to meshes: one vertex for each different v/vt/vn, one mesh for each part.
#pragma once

#include "scene/obj/obj_data.h"

namespace gw::scene {

/// Throws Error, with the element's line, for an index beyond the vertices of the file.
void check_indices(const ObjData& obj);

/// The meshes of obj.parts, in their order; polygons in the order of the file.
std::vector<MeshData> make_meshes(const ObjData& obj);

/// "v index 9 is out of range; expected 1 .. 8 or -8 .. -1", or "...; the file has no v".
std::string index_fault(std::string_view kind, long long index, std::size_t count);

}  // namespace gw::scene
