#include "scene/gltf/gltf_mesh.h"

#include "scene/gltf/accessors.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace gw::scene {
namespace {

enum Mode : std::size_t { Points, Lines, LineLoop, LineStrip, Triangles, Strip, Fan };

Primitive primitive_of(std::size_t mode) {
    switch (mode) {
        case Points: return Primitive::Points;
        case Lines: return Primitive::Lines;
        case LineLoop:
        case LineStrip: return Primitive::LineStrip;
        case Strip: return Primitive::TriangleStrip;
        case Fan: return Primitive::TriangleFan;
        default: return Primitive::Triangles;
    }
}

std::size_t corners_per_piece(std::size_t mode) {
    return mode == Points ? 1 : mode == Triangles ? 3 : mode == Lines ? 2 : 1;
}

vec3 vec3_at(const Elements<float>& elements, std::size_t i) {
    const float* v = elements[i];
    return {v[0], v[1], v[2]};
}

void expect_count(const JsonValue& value, std::size_t count, std::size_t vertices) {
    if (count != vertices)
        value.fail("has " + std::to_string(count) + " elements; expected " +
                   std::to_string(vertices) + ", as POSITION has");
}

std::vector<std::uint32_t> read_indices(const GltfDocument& document, const JsonValue& value,
                                        std::size_t vertices) {
    std::vector<std::uint32_t> indices = read_integers(document, value, "SCALAR").numbers;
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= vertices)
            value.fail("has index " + std::to_string(indices[i]) + " at " + std::to_string(i) +
                       "; expected less than " + std::to_string(vertices) +
                       ", the number of vertices");
    return indices;
}

/// The corners of triangle i of a strip or a fan, in the orientation of the first.
std::array<std::size_t, 3> corners_of(Primitive primitive, std::size_t i) {
    if (primitive == Primitive::TriangleFan) return {0, i + 1, i + 2};
    if (primitive == Primitive::TriangleStrip)
        return i % 2 == 0 ? std::array{i, i + 1, i + 2} : std::array{i + 1, i, i + 2};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

/// Separate triangles, each with its own normal.
void make_flat(MeshData& mesh) {
    MeshData flat;
    const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    const std::size_t triangles = mesh.primitive == Primitive::Triangles ? corners / 3
                                  : corners < 3                          ? 0
                                                                         : corners - 2;
    for (std::size_t i = 0; i < triangles; ++i) {
        std::array<std::uint32_t, 3> at{};
        const std::array<std::size_t, 3> places = corners_of(mesh.primitive, i);
        for (std::size_t k = 0; k < 3; ++k)
            at[k] = mesh.indices.empty() ? std::uint32_t(places[k]) : mesh.indices[places[k]];
        const dvec3 a(mesh.positions[at[0]]);
        const dvec3 n = cross3(dvec3(mesh.positions[at[1]]) - a, dvec3(mesh.positions[at[2]]) - a);
        const vec3 normal = n == dvec3(0) ? vec3(0, 0, 1) : vec3(n / length(n));
        for (const std::uint32_t vertex : at) {
            flat.positions.push_back(mesh.positions[vertex]);
            flat.normals.push_back(normal);
            if (!mesh.texcoords.empty()) flat.texcoords.push_back(mesh.texcoords[vertex]);
        }
    }
    mesh = std::move(flat);
}

class PrimitiveReader {
public:
    PrimitiveReader(const GltfDocument& document, const JsonValue& primitive,
                    const std::string& name)
        : document_(document),
          primitive_(primitive),
          attributes_(primitive.at("attributes")),
          name_(name) {}

    GltfMesh read(std::size_t texcoord_set) {
        const auto mode_value = primitive_.find("mode");
        const std::size_t mode = mode_value ? mode_value->whole(0, Fan) : Triangles;
        MeshData& mesh = out_.mesh;
        mesh.primitive = primitive_of(mode);
        read_positions(mesh);
        read_normals(mesh);
        read_texcoords(mesh, texcoord_set);
        read_colors();
        warn_left_out();
        if (const auto indices = primitive_.find("indices"))
            mesh.indices = read_indices(document_, *indices, mesh.positions.size());
        trim(mesh, mode);
        if (mesh.positions.empty())
            warn("empty", "a primitive has too few corners and is left out");
        if (mode >= Triangles && mesh.normals.empty()) make_flat(mesh);
        return std::move(out_);
    }

private:
    void read_positions(MeshData& mesh) {
        const Elements<float> p = read_floats(document_, attributes_.at("POSITION"), {"VEC3"});
        for (std::size_t i = 0; i < p.count(); ++i) {
            mesh.positions.push_back(vec3_at(p, i));
            for (int k = 0; k < 3; ++k)
                if (!placeable.contains(mesh.positions.back()[k]))
                    attributes_.at("POSITION")
                        .fail("is beyond 1e18 at element " + std::to_string(i) + "; expected less");
        }
    }

    void read_normals(MeshData& mesh) {
        const auto value = attributes_.find("NORMAL");
        if (!value) return;
        const Elements<float> n = read_floats(document_, *value, {"VEC3"});
        expect_count(*value, n.count(), mesh.positions.size());
        for (std::size_t i = 0; i < n.count(); ++i) mesh.normals.push_back(vec3_at(n, i));
    }

    void read_texcoords(MeshData& mesh, std::size_t set) {
        const auto value = attributes_.find("TEXCOORD_" + std::to_string(set));
        if (!value) return;
        const Elements<float> st = read_floats(document_, *value, {"VEC2"});
        expect_count(*value, st.count(), mesh.positions.size());
        for (std::size_t i = 0; i < st.count(); ++i)
            mesh.texcoords.emplace_back(st[i][0], 1 - st[i][1]);
    }

    void read_colors() {
        const auto value = attributes_.find("COLOR_0");
        if (!value) return;
        const Elements<float> c = read_floats(document_, *value, {"VEC3", "VEC4"});
        expect_count(*value, c.count(), out_.mesh.positions.size());
        glm::dvec4 sum(0);
        for (std::size_t i = 0; i < c.count(); ++i) {
            sum += glm::dvec4(c[i][0], c[i][1], c[i][2], c.components == 4 ? c[i][3] : 1);
            out_.colors_vary |= !std::equal(c[i], c[i] + c.components, c[0]);
        }
        out_.mean_color = vec4(glm::clamp(sum / double(c.count()), 0.0, 1.0));
        if (out_.colors_vary) warn("COLOR_0", "vertex colours are drawn as their mean");
    }

    void warn_left_out() const {
        if (primitive_.find("targets"))
            warn("targets", "morph targets are left out; it is drawn in its first shape");
    }

    /// Corners that make no whole piece are not drawn [GLTF2 3.7.2.1]; a loop is closed.
    static void trim(MeshData& mesh, std::size_t mode) {
        if (mesh.indices.empty()) {
            const auto n = std::uint32_t(mesh.positions.size());
            for (std::uint32_t i = 0; i < n; ++i) mesh.indices.push_back(i);
        }
        if (mode == LineLoop) mesh.indices.push_back(mesh.indices.front());
        const std::size_t least = mode >= Triangles ? 3 : mode == Points ? 1 : 2;
        const std::size_t count =
            mesh.indices.size() - mesh.indices.size() % corners_per_piece(mode);
        mesh.indices.resize(count);
        if (count < least) mesh = {.primitive = mesh.primitive};
    }

    void warn(const std::string& kind, const std::string& text) const {
        document_.warn(kind, "object '" + printable(name_) + "': " + text);
    }

    const GltfDocument& document_;
    const JsonValue primitive_, attributes_;
    const std::string& name_;
    GltfMesh out_;
};

}  // namespace

GltfMesh read_primitive(const GltfDocument& document, const JsonValue& primitive,
                        std::size_t texcoord_set, const std::string& name) {
    return PrimitiveReader(document, primitive, name).read(texcoord_set);
}

}  // namespace gw::scene
