#include "scene/gltf/gltf_mesh.h"

#include "scene/gltf/accessors.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <span>

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

std::size_t set_count(const JsonValue& attributes, const std::string& name) {
    std::size_t sets = 0;
    while (attributes.find(name + std::to_string(sets))) ++sets;
    return sets;
}

class PrimitiveReader {
public:
    PrimitiveReader(const GltfDocument& document, const JsonValue& primitive,
                    const std::string& name)
        : document_(document),
          primitive_(primitive),
          attributes_(primitive.at("attributes")),
          name_(name) {}

    GltfMesh read(const CoordinateSet& own, const std::optional<CoordinateSet>& other) {
        const auto mode_value = primitive_.find("mode");
        const std::size_t mode = mode_value ? mode_value->whole(0, Fan) : Triangles;
        MeshData& mesh = out_.mesh;
        mesh.primitive = primitive_of(mode);
        mesh.positions = read_vectors(attributes_.at("POSITION"), 0);
        if (const auto normals = attributes_.find("NORMAL"))
            mesh.normals = read_vectors(*normals, mesh.positions.size());
        check_normals(mesh.normals);
        mesh.texcoords = read_texcoords(own);
        if (other) out_.other_texcoords = read_texcoords(*other);
        read_colors();
        read_targets();
        read_influences();
        if (const auto indices = primitive_.find("indices"))
            mesh.indices = read_indices(document_, *indices, mesh.positions.size());
        trim(mesh, mode);
        if (mesh.positions.empty())
            warn("empty", "a primitive has too few corners and is left out");
        return std::move(out_);
    }

private:
    /// `count` vectors, or any number if it is 0.
    std::vector<vec3> read_vectors(const JsonValue& value, std::size_t count) {
        const Elements<float> read = read_floats(document_, value, {"VEC3"});
        if (count != 0) expect_count(value, read.count(), count);
        std::vector<vec3> vectors;
        for (std::size_t i = 0; i < read.count(); ++i) {
            vectors.push_back(vec3_at(read, i));
            for (int k = 0; k < 3; ++k)
                if (!placeable.contains(double(vectors.back()[k])))
                    value.fail("is beyond 1e18 at element " + std::to_string(i) +
                               "; expected less");
        }
        return vectors;
    }

    std::vector<vec2> read_texcoords(const CoordinateSet& set) {
        std::vector<vec2> texcoords;
        const auto value = attributes_.find("TEXCOORD_" + std::to_string(set.index));
        if (!value) return texcoords;
        const Elements<float> st = read_floats(document_, *value, {"VEC2"});
        expect_count(*value, st.count(), out_.mesh.positions.size());
        for (std::size_t i = 0; i < st.count(); ++i) {
            const vec2 upwards(st[i][0], 1 - st[i][1]);
            texcoords.push_back(set.turn ? set.turn->moved(upwards) : upwards);
        }
        return texcoords;
    }

    void check_normals(std::vector<vec3>& normals) {
        const auto none = std::size_t(std::count(normals.begin(), normals.end(), vec3(0)));
        if (none == 0) return;
        const bool is_flat = 2 * none > normals.size();
        warn("NORMAL", std::to_string(none) + " of its normals have length 0: " +
                           (is_flat ? "the faces' own normals stand in" : "it is dark there"));
        if (is_flat) normals.clear();
    }

    void read_colors() {
        const auto value = attributes_.find("COLOR_0");
        if (!value) return;
        const Elements<float> c = read_floats(document_, *value, {"VEC3", "VEC4"});
        expect_count(*value, c.count(), out_.mesh.positions.size());
        const auto alpha_of = [&](std::size_t i) { return c.components == 4 ? c[i][3] : 1; };
        glm::dvec4 sum(0);
        bool vary = false, alphas_vary = false;
        for (std::size_t i = 0; i < c.count(); ++i) {
            sum += glm::dvec4(c[i][0], c[i][1], c[i][2], alpha_of(i));
            vary |= !std::equal(c[i], c[i] + 3, c[0]);
            alphas_vary |= alpha_of(i) != alpha_of(0);
        }
        out_.mean_color = vec4(glm::clamp(sum / double(c.count()), 0.0, 1.0));
        for (std::size_t i = 0; vary && i < c.count(); ++i)
            out_.colors.emplace_back(c[i][0], c[i][1], c[i][2], 1);
        for (std::size_t i = 0; alphas_vary && i < c.count(); ++i)
            out_.mesh.colors.emplace_back(1, 1, 1, alpha_of(i));
        if (alphas_vary) out_.mean_color->w = 1;
    }

    void read_targets() {
        const auto targets = primitive_.find("targets");
        const std::size_t vertices = out_.mesh.positions.size();
        for (std::size_t i = 0; targets && i < targets->size(); ++i) {
            const JsonValue json = (*targets)[i];
            MorphTarget target;
            for (const std::string& key : json.keys()) {
                if (key == "POSITION") target.positions = read_vectors(json.at(key), vertices);
                if (key == "NORMAL") target.normals = read_vectors(json.at(key), vertices);
                if (key != "POSITION" && key != "NORMAL" && key != "TANGENT")
                    warn("target " + key, "its morph targets do not change " + printable(key));
            }
            out_.targets.push_back(std::move(target));
        }
    }

    void read_influences() {
        const std::size_t sets = set_count(attributes_, "JOINTS_"),
                          vertices = out_.mesh.positions.size();
        out_.influences = 4 * sets;
        out_.influenced.resize(vertices * out_.influences);
        for (std::size_t set = 0; set < sets; ++set) {
            const JsonValue joints_value = attributes_.at("JOINTS_" + std::to_string(set)),
                            weights_value = attributes_.at("WEIGHTS_" + std::to_string(set));
            const Elements<std::uint32_t> joints = read_integers(document_, joints_value, "VEC4");
            const Elements<float> weights = read_floats(document_, weights_value, {"VEC4"});
            expect_count(joints_value, joints.count(), vertices);
            expect_count(weights_value, weights.count(), vertices);
            for (std::size_t i = 0; i < vertices; ++i)
                for (std::size_t k = 0; k < 4; ++k) {
                    if (weights[i][k] < 0 || weights[i][k] > 1e6f)
                        weights_value.fail("has a weight below 0 or beyond 1e6 at element " +
                                           std::to_string(i) + "; expected 0 to 1");
                    out_.influenced[i * out_.influences + 4 * set + k] = {joints[i][k],
                                                                          weights[i][k]};
                    out_.joints = std::max(out_.joints, std::size_t{joints[i][k]} + 1);
                }
        }
        for (std::size_t i = 0; i < vertices; ++i)
            normalize({out_.influenced.data() + i * out_.influences, out_.influences});
    }

    /// A vertex without weights belongs to its first joint.
    static void normalize(std::span<Influence> influences) {
        double sum = 0;
        for (const Influence& by : influences) sum += double(by.weight);
        for (Influence& by : influences) by.weight = sum > 0 ? float(double(by.weight) / sum) : 0;
        if (sum == 0 && !influences.empty()) influences.front().weight = 1;
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
                        const CoordinateSet& own, const std::optional<CoordinateSet>& other,
                        const std::string& name) {
    return PrimitiveReader(document, primitive, name).read(own, other);
}

std::size_t numbers_of_primitive(const GltfDocument& document, const JsonValue& primitive) {
    std::size_t numbers = 0;
    const auto add = [&](const JsonValue& attributes) {
        for (const std::string& key : attributes.keys())
            numbers += count_of(document, attributes.at(key));
    };
    add(primitive.at("attributes"));
    if (const auto targets = primitive.find("targets"))
        for (std::size_t i = 0; i < targets->size(); ++i) add((*targets)[i]);
    if (const auto indices = primitive.find("indices")) numbers += count_of(document, *indices);
    return numbers;
}

}  // namespace gw::scene
