// A mesh: immutable vertices and primitives, checked and decomposed once.
// docs/manual/geometry.md, "Primitives". Does not know materials, files or transforms.
#pragma once

#include "gw/material.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gw {

/// GL's glBegin modes. Polygons may be concave: they are triangulated.
enum class Primitive {
    Points,
    Lines,
    LineStrip,
    Triangles,
    TriangleStrip,
    TriangleFan,
    Quads,
    Polygons
};

/// The texture coordinates of a further unit, as those of the first.
struct UnitTexcoords {
    std::vector<vec2> st;  ///< empty: the draw's current ones
    std::vector<vec2> rq;  ///< empty: (0, 1) if there are st
    bool operator==(const UnitTexcoords&) const = default;
};

/// The data of a mesh, in object space. Vertex arrays are either empty or as long as `positions`.
struct MeshData {
    Primitive primitive = Primitive::Triangles;
    std::vector<vec3> positions;
    /// of any length. Empty: the draw's current normal
    std::vector<vec3> normals;
    std::vector<vec2> texcoords;         ///< s, t. Empty: the draw's current ones
    std::vector<vec4> colors;            ///< used if lighting is off. Empty: the current one
    std::vector<std::uint32_t> indices;  ///< into the vertices. Empty: 0, 1, 2, ...
    /// Polygons only: the number of vertices of each. Empty: all vertices are one polygon
    std::vector<std::uint32_t> polygon_sizes;
    /// The identifier of each polygon, quad, triangle, line or point, before triangulation, for
    /// ColorSource::PolygonId. Empty: 0, 1, 2, ...
    std::vector<std::uint32_t> polygon_ids;
    /// The fourth coordinate of each position, of any sign. Empty: 1
    std::vector<float> w;
    /// r, q of the texture coordinates. Empty: (0,1) if there are texcoords
    std::vector<vec2> texcoords_rq;
    std::array<UnitTexcoords, 3> more_texcoords;  ///< of texture units 1 to 3
    /// Triangles, Quads, Polygons: 0 if the side from this vertex to the next is no edge of the
    /// outline. Empty: all sides are edges
    std::vector<std::uint8_t> edge_flags;
    /// Materials that change from vertex to vertex, and the index of each vertex's material. Empty:
    /// the draw's
    std::vector<FaceMaterials> materials;
    std::vector<std::uint32_t> material_indices;
    std::vector<vec3> secondary_colors;  ///< used if lighting is off. Empty: the current one
    std::vector<float> fog_coordinates;  ///< Empty: the current one
    bool operator==(const MeshData&) const = default;
};

/// A triangle after decomposition. The order of its vertices keeps the polygon's orientation.
struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    /// the vertex that gives a flat-shaded face its colour (GL: the last, of a polygon the first)
    std::uint32_t provoking;
    std::uint32_t polygon;  ///< ordinal of its polygon
    /// bit k: the side from vertex[k] to vertex[k+1] is an edge of the polygon
    std::uint8_t edges = 7;
    bool operator==(const Triangle&) const = default;
};

enum class MeshKind : std::uint8_t { Points, Lines, Triangles };

/// MeshData checked and decomposed, by make_mesh only.
class Mesh {
public:
    const MeshData& data() const { return data_; }
    MeshKind kind() const { return kind_; }
    /// Of MeshKind::Triangles.
    std::span<const Triangle> triangles() const { return triangles_; }
    /// Of MeshKind::Lines: first and second vertex.
    std::span<const std::array<std::uint32_t, 2>> lines() const { return lines_; }
    /// Of MeshKind::Points.
    std::span<const std::uint32_t> points() const { return points_; }
    std::uint32_t polygon_count() const { return polygon_count_; }
    /// The identifier of the polygon, line or point with this ordinal.
    std::uint32_t polygon_id(std::uint32_t ordinal) const {
        return data_.polygon_ids.empty() ? ordinal : data_.polygon_ids[ordinal];
    }
    std::uint32_t vertex_count() const {
        return static_cast<std::uint32_t>(data_.positions.size());
    }
    /// Differs from that of every other mesh of the process. An address may be used again.
    std::uint64_t number() const { return number_; }

private:
    friend std::shared_ptr<const Mesh> make_mesh(MeshData data);
    // Most draws read only the members up to the positions.
    std::uint64_t number_ = 0;
    MeshKind kind_ = MeshKind::Triangles;
    std::uint32_t polygon_count_ = 0;
    std::vector<std::array<std::uint32_t, 2>> lines_;
    std::vector<std::uint32_t> points_;
    std::vector<Triangle> triangles_;
    MeshData data_;
};

using MeshRef = std::shared_ptr<const Mesh>;

/// The largest number of vertices, and of triangles, of one mesh.
inline constexpr std::uint32_t max_mesh_size = 1u << 28;

/// Throws Error if an array has the wrong length, an index is out of range or a value is not
/// finite. Throws Error too if a polygon has fewer than 3 vertices or the counts do not fit the
/// primitive. Polygons without area are accepted and draw nothing.
MeshRef make_mesh(MeshData data);

}  // namespace gw
