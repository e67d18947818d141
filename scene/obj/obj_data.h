// The statements of an OBJ file: vertices, corners, elements, before they become meshes. Plain data
// between the steps read_obj.cpp -> normals.cpp -> obj_parts.cpp.
#pragma once

#include "gw/base/types.h"
#include "gw/mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gw::scene {

inline constexpr std::uint32_t absent = 0xffffffff;

/// A corner of a face: indices from 0 into positions, texcoords, normals; `absent` if the file
/// gives none.
struct Corner {
    std::uint32_t v = absent, vt = absent, vn = absent;
    bool operator==(const Corner&) const = default;
};

/// Smoothing groups are 1 and up; these two are the other values.
inline constexpr std::int32_t smooth_by_angle = -1;  ///< no `s` statement before the face
inline constexpr std::int32_t smooth_off = 0;

/// A face, a line segment or a point: its corners are corners[first] .. corners[first + count - 1].
struct Element {
    std::uint32_t first = 0, count = 0;
    std::uint32_t part = 0;
    std::int32_t smoothing = smooth_by_angle;
    std::int32_t line = 0;
};

/// The elements of one kind with one name and one material, anywhere in the file: one object.
struct Part {
    std::string name;      ///< `g`, else `o`, else empty
    std::string material;  ///< `usemtl`; empty: none
    int material_line = 0;
    Primitive primitive = Primitive::Polygons;  ///< Polygons, Lines or Points
    std::uint32_t elements = 0, corners = 0;    ///< how many
};

struct ObjData {
    std::string file;
    std::vector<vec3> positions, normals;
    std::vector<vec2> texcoords;
    std::vector<vec4> colors;  ///< empty, or one for each position
    std::vector<Corner> corners;
    std::vector<Element> elements;
    std::vector<Part> parts;
};

}  // namespace gw::scene
