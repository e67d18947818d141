#include "gw/mesh.h"

#include "gw/base/finite.h"
#include "gw/error.h"
#include "gw/mesh/decompose.h"

#include <atomic>
#include <cmath>
#include <numeric>
#include <string>

namespace gw {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Error("mesh: " + what); }

std::string count(std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

void check_length(std::size_t length, std::size_t vertices, const char* name,
                  const char* many = nullptr) {
    if (length == 0 || length == vertices) return;
    const std::string plural = many ? many : std::string(name) + "s";
    fail(count(length, name, plural.c_str()) + " for " + count(vertices, "position", "positions") +
         "; expected as many, or none");
}

template <class Vector>
void check_finite(const std::vector<Vector>& values, const char* name) {
    if (values.empty() || all_finite(&values[0].x, values.size() * Vector::length())) return;
    for (std::size_t i = 0; i < values.size(); ++i)
        for (int k = 0; k < Vector::length(); ++k)
            if (!std::isfinite(values[i][k]))
                fail(std::string(name) + " " + std::to_string(i) +
                     " has a component that is not a finite number");
}

void check_finite(const std::vector<float>& values, const char* name) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            fail(std::string(name) + " " + std::to_string(i) + " is not a finite number");
}

void check_vertices(const MeshData& data) {
    const std::size_t n = data.positions.size();
    if (n > max_mesh_size)
        fail(count(n, "position", "positions") + "; at most " + std::to_string(max_mesh_size));
    check_length(data.normals.size(), n, "normal");
    check_length(data.texcoords.size(), n, "texcoord");
    check_length(data.colors.size(), n, "color");
    check_finite(data.positions, "position");
    check_finite(data.normals, "normal");
    check_finite(data.texcoords, "texcoord");
    check_finite(data.colors, "color");
    check_length(data.w.size(), n, "w", "w");
    check_length(data.texcoords_rq.size(), data.texcoords.size(), "r, q", "pairs r, q");
    check_length(data.edge_flags.size(), n, "edge flag");
    check_length(data.material_indices.size(), n, "material index", "material indices");
    check_length(data.secondary_colors.size(), n, "secondary color");
    check_length(data.fog_coordinates.size(), n, "fog coordinate");
    check_finite(data.texcoords_rq, "r, q");
    check_finite(data.secondary_colors, "secondary color");
    check_finite(data.w, "w");
    check_finite(data.fog_coordinates, "fog coordinate");
    for (const UnitTexcoords& unit : data.more_texcoords) {
        check_length(unit.st.size(), n, "texcoord of a unit", "texcoords of a unit");
        check_length(unit.rq.size(), unit.st.size(), "r, q of a unit", "pairs r, q of a unit");
        check_finite(unit.st, "texcoord of a unit");
        check_finite(unit.rq, "r, q of a unit");
    }
    for (std::size_t i = 0; i < data.material_indices.size(); ++i)
        if (data.material_indices[i] >= data.materials.size())
            fail("material index " + std::to_string(i) + " is " +
                 std::to_string(data.material_indices[i]) + "; there are " +
                 count(data.materials.size(), "material", "materials"));
}

void check_indices(const MeshData& data) {
    const std::size_t n = data.positions.size();
    if (data.indices.size() > std::size_t{3} * max_mesh_size)
        fail(std::to_string(data.indices.size()) + " indices are too many");
    for (std::size_t i = 0; i < data.indices.size(); ++i)
        if (data.indices[i] >= n)
            fail("index " + std::to_string(i) + " is " + std::to_string(data.indices[i]) +
                 "; there are " + count(n, "position", "positions"));
}

void check_polygon_sizes(const MeshData& data, std::size_t corners) {
    if (data.primitive != Primitive::Polygons) {
        if (!data.polygon_sizes.empty()) fail("polygon_sizes are for Polygons only");
        return;
    }
    std::size_t sum = 0;
    for (std::size_t i = 0; i < data.polygon_sizes.size(); ++i) {
        if (data.polygon_sizes[i] < 3)
            fail("polygon " + std::to_string(i) + " has " +
                 count(data.polygon_sizes[i], "vertex", "vertices") + "; expected 3 or more");
        sum += data.polygon_sizes[i];
    }
    if (!data.polygon_sizes.empty() && sum != corners)
        fail("the polygon sizes add up to " + std::to_string(sum) + "; there are " +
             count(corners, "index", "indices"));
}

void check_polygon_ids(const MeshData& data, std::size_t polygons) {
    if (!data.polygon_ids.empty() && data.polygon_ids.size() != polygons)
        fail(count(data.polygon_ids.size(), "polygon id", "polygon ids") + " for " +
             count(polygons, "polygon", "polygons") + "; expected as many, or none");
}

std::vector<std::uint32_t> corners_of(const MeshData& data) {
    if (!data.indices.empty()) return data.indices;
    std::vector<std::uint32_t> all(data.positions.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

// Whether `corners` vertices make whole primitives. 0 vertices are allowed and draw nothing.
bool fits(Primitive primitive, std::size_t corners) {
    switch (primitive) {
        case Primitive::Points: return true;
        case Primitive::Lines: return corners % 2 == 0;
        case Primitive::LineStrip: return corners != 1;
        case Primitive::Triangles: return corners % 3 == 0;
        case Primitive::Quads: return corners % 4 == 0;
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan:
        case Primitive::Polygons: return corners == 0 || corners >= 3;
    }
    return false;
}

const char* needs(Primitive primitive) {
    switch (primitive) {
        case Primitive::Points: return "Points: any number";
        case Primitive::Lines: return "Lines: a multiple of 2";
        case Primitive::LineStrip: return "LineStrip: 2 or more";
        case Primitive::Triangles: return "Triangles: a multiple of 3";
        case Primitive::Quads: return "Quads: a multiple of 4";
        case Primitive::TriangleStrip: return "TriangleStrip: 3 or more";
        case Primitive::TriangleFan: return "TriangleFan: 3 or more";
        case Primitive::Polygons: return "Polygons: 3 or more";
    }
    return "";
}

MeshKind kind_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::Points: return MeshKind::Points;
        case Primitive::Lines:
        case Primitive::LineStrip: return MeshKind::Lines;
        case Primitive::Triangles:
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan:
        case Primitive::Quads:
        case Primitive::Polygons: return MeshKind::Triangles;
    }
    return MeshKind::Triangles;
}

}  // namespace

MeshRef make_mesh(MeshData data) {
    if (data.primitive > Primitive::Polygons)
        fail("primitive " + std::to_string(int(data.primitive)) + "; expected 0 to 7");
    check_vertices(data);
    check_indices(data);
    std::vector<std::uint32_t> corners = corners_of(data);
    if (!fits(data.primitive, corners.size()))
        fail(count(corners.size(), "index", "indices") + " do not fit " + needs(data.primitive));
    check_polygon_sizes(data, corners.size());

    static std::atomic<std::uint64_t> made = 0;
    auto mesh = std::make_shared<Mesh>();
    mesh->number_ = made.fetch_add(1, std::memory_order_relaxed);
    mesh->kind_ = kind_of(data.primitive);
    switch (mesh->kind_) {
        case MeshKind::Points:
            mesh->polygon_count_ = static_cast<std::uint32_t>(corners.size());
            mesh->points_ = std::move(corners);
            break;
        case MeshKind::Lines:
            mesh->lines_ = decompose_lines(data.primitive, corners);
            mesh->polygon_count_ = static_cast<std::uint32_t>(mesh->lines_.size());
            break;
        case MeshKind::Triangles:
            mesh->triangles_ = decompose_triangles(data, corners);
            mesh->polygon_count_ =
                mesh->triangles_.empty() ? 0 : mesh->triangles_.back().polygon + 1;
            break;
    }
    if (mesh->triangles_.size() > max_mesh_size)
        fail(std::to_string(mesh->triangles_.size()) + " triangles; at most " +
             std::to_string(max_mesh_size));
    check_polygon_ids(data, mesh->polygon_count_);
    mesh->data_ = std::move(data);
    return mesh;
}

}  // namespace gw
