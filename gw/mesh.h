// A mesh: immutable vertices and primitives, checked and decomposed once. docs/manual.md,
// "Primitives".
// Does not know materials, files or transforms.
#pragma once

#include "gw/base/types.h"

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

/// What a mesh is made of, all in object space. Vertex arrays are either empty or as long as
/// `positions`.
struct MeshData {
    Primitive primitive = Primitive::Triangles;
    std::vector<vec3> positions;
    /// of any length; normalised by the machine. Empty: (0,0,1)
    std::vector<vec3> normals;
    std::vector<vec2> texcoords;         ///< s, t. Empty: (0,0)
    std::vector<vec4> colors;            ///< used where lighting is off. Empty: (1,1,1,1)
    std::vector<std::uint32_t> indices;  ///< into the vertices. Empty: 0, 1, 2, ...
    std::vector<std::uint32_t>
        polygon_sizes;  ///< Polygons only: vertices of each polygon; empty: one polygon of all
    /// Identifier of each polygon (quad, triangle, line, point as given, before triangulation) for
    /// ColorSource::PolygonId. Empty: 0, 1, 2, ...
    std::vector<std::uint32_t> polygon_ids;
    bool operator==(const MeshData&) const = default;
};

/// A triangle after decomposition. Its order keeps the polygon's orientation.
struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t
        /// the vertex whose colour a flat-shaded face has (GL: the last; a polygon's first)
        provoking;
    std::uint32_t polygon;  ///< ordinal of the polygon it came from
    /// bit k: the side from vertex[k] to vertex[k+1] is an edge of the polygon
    std::uint8_t edges = 7;
    bool operator==(const Triangle&) const = default;
};

enum class MeshKind { Points, Lines, Triangles };

/// MeshData made ready to draw. Only make_mesh makes one.
class Mesh {
public:
    const MeshData& data() const { return data_; }
    MeshKind kind() const { return kind_; }
    /// Of a MeshKind::Triangles mesh.
    std::span<const Triangle> triangles() const { return triangles_; }
    /// Of a MeshKind::Lines mesh (first, second vertex) ...
    std::span<const std::array<std::uint32_t, 2>> lines() const { return lines_; }
    /// ... and of a MeshKind::Points mesh.
    std::span<const std::uint32_t> points() const { return points_; }
    std::uint32_t polygon_count() const { return polygon_count_; }
    /// The identifier of polygon `ordinal` (for lines and points: of the ordinal-th).
    std::uint32_t polygon_id(std::uint32_t ordinal) const {
        return data_.polygon_ids.empty() ? ordinal : data_.polygon_ids[ordinal];
    }
    std::uint32_t vertex_count() const {
        return static_cast<std::uint32_t>(data_.positions.size());
    }

private:
    friend std::shared_ptr<const Mesh> make_mesh(MeshData data);
    MeshData data_;
    MeshKind kind_ = MeshKind::Triangles;
    std::vector<Triangle> triangles_;
    std::vector<std::array<std::uint32_t, 2>> lines_;
    std::vector<std::uint32_t> points_;
    std::uint32_t polygon_count_ = 0;
};

using MeshRef = std::shared_ptr<const Mesh>;

/// The largest number of vertices, and of triangles, of one mesh.
inline constexpr std::uint32_t max_mesh_size = 1u << 28;

/// Throws Error when an array has the wrong length, an index is out of range, a value is not
/// finite, a polygon has fewer than 3 vertices or the counts do not fit the primitive. Zero-area
/// polygons are kept: they draw nothing.
MeshRef make_mesh(MeshData data);

}  // namespace gw
