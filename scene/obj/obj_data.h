// The statements of an OBJ file as plain data: vertices, corners, elements. ObjBuilder collects them
// for read_obj.cpp, normals.cpp adds normals, make_meshes makes one mesh for each part. Does not read
// text.
#pragma once

#include "gw/base/types.h"
#include "gw/mesh.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
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
    std::uint32_t elements = 0, corners = 0;    ///< their numbers
    dvec3 origin{0};                            ///< of the mesh's positions (origins.h)
};

/// A v, vt or vn that is not finite: an error if an element uses it.
struct NotFinite {
    std::uint32_t index = 0;
    int line = 0;
    std::string fault;
};

struct ObjData {
    std::string file;
    /// float32 values, or those of the text (origins.h)
    std::vector<dvec3> positions;
    std::vector<vec3> normals;
    std::vector<vec2> texcoords;
    std::vector<vec4> colors;  ///< empty, or one for each position
    std::vector<Corner> corners;
    std::vector<Element> elements;
    std::vector<Part> parts;
    /// in the order of their indices, which a face gives
    std::vector<NotFinite> bad_positions, bad_texcoords, bad_normals;
};

/// The state set by OBJ statements (object, group, material, smoothing), and the elements added
/// under it.
class ObjBuilder {
public:
    ObjData obj;
    std::int32_t smoothing = smooth_by_angle;

    /// A new `o` ends the group before it.
    void set_object(std::string_view name);
    void set_group(std::string_view name);
    void set_material(std::string_view name, int line);

    /// Take the corners at the end of obj.corners: as one face, as segments between neighbours, as
    /// single points.
    void add_face(std::uint32_t corners, int line);
    void add_segments(std::uint32_t corners, int line);
    void add_points(std::uint32_t corners, int line);

private:
    std::uint32_t part_of(Primitive primitive);
    void add(Primitive primitive, std::size_t first, std::uint32_t count, int line);

    std::string object_, group_, material_;
    int material_line_ = 0;
    std::map<std::tuple<std::string, std::string, Primitive>, std::uint32_t> parts_;
    std::uint32_t part_ = 0;
    /// of part_; absent after a statement that may change the part
    std::optional<Primitive> part_primitive_;
};

/// Throws Error, with the element's line, for an index beyond the vertices of the file; with the
/// vertex's line for one that is not finite.
void check_indices(const ObjData& obj);

/// The meshes of obj.parts, in their order; polygons in the order of the file. A mesh has one vertex
/// for each different v/vt/vn.
std::vector<MeshData> make_meshes(const ObjData& obj);

/// "v index 9 is out of range; expected 1 .. 8 or -8 .. -1", or "...; the file has no v".
std::string index_fault(std::string_view kind, long long index, std::size_t count);

}  // namespace gw::scene
