#include "scene/gltf/gltf_nodes.h"

#include "scene/geometry/transform.h"
#include "scene/gltf/accessors.h"
#include "scene/validate/rules.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

template <class Vector>
Vector numbers_of(const std::optional<JsonValue>& value, Vector v, Range range = placeable) {
    if (!value) return v;
    if (value->size() != std::size_t(Vector::length()))
        value->fail("has " + std::to_string(value->size()) + " elements; expected " +
                    std::to_string(Vector::length()));
    for (int k = 0; k < Vector::length(); ++k) v[k] = (*value)[std::size_t(k)].number(range);
    return v;
}

/// The turn of a quaternion x, y, z, w of length 1.
dmat4 turned(const dvec4& q) {
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    dmat4 m(1);
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
    m[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
    m[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
    return m;
}

dmat4 matrix_of(const JsonValue& value) {
    if (value.size() != 16)
        value.fail("has " + std::to_string(value.size()) + " elements; expected 16");
    dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = value[std::size_t(i)].number(placeable);
    if (dvec4(m[0][3], m[1][3], m[2][3], m[3][3]) != dvec4(0, 0, 0, 1))
        value.fail("is not affine; expected 0, 0, 0, 1 as its last row");
    return m;
}

/// The roots of the default scene; of a file without scenes, all nodes that are no child.
std::vector<std::size_t> roots_of(const GltfDocument& document) {
    std::vector<std::size_t> roots;
    const JsonValue& root = document.root();
    if (document.count("scenes") > 0) {
        const auto choice = root.find("scene");
        const JsonValue scene = choice ? document.element("scenes", *choice) : root.at("scenes")[0];
        if (document.count("scenes") > 1)
            document.warn("scenes", "has " + std::to_string(document.count("scenes")) +
                                        " scenes; " + scene.place() + " is drawn");
        const auto list = scene.find("nodes");
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            const JsonValue index = (*list)[i];
            document.element("nodes", index);
            roots.push_back(index.whole(0, document.count("nodes") - 1));
        }
        return roots;
    }
    std::vector<bool> is_child(document.count("nodes"), false);
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (const auto children = root.at("nodes")[i].find("children"))
            for (std::size_t k = 0; k < children->size(); ++k)
                is_child[(*children)[k].whole(0, is_child.size() - 1)] = true;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(i);
    return roots;
}

GltfPlace place_of(const JsonValue& node) {
    GltfPlace place;
    const auto matrix = node.find("matrix"), rotation = node.find("rotation");
    if (matrix) {
        place.matrix = matrix_of(*matrix);
        return place;
    }
    place.scale = numbers_of(node.find("scale"), dvec3(1));
    place.translation = numbers_of(node.find("translation"), dvec3(0));
    if (!rotation) return place;
    const dvec4 q = numbers_of(rotation, dvec4(0, 0, 0, 1), {-2, 2});
    const double size = std::sqrt(dot4(q, q));
    if (size == 0) rotation->fail("is 0; expected a quaternion of length 1");
    place.rotation = q / size;
    return place;
}

}  // namespace

dmat4 GltfPlace::parent_from_node() const {
    return matrix * (gw::scene::translation(translation) * (turned(rotation) * scaling(scale)));
}

dmat4 drawable(const dmat4& m) {
    const dmat4 thick = thickened(m);
    return fault_of(thick) ? translation(dvec3(m[3])) * scaling(dvec3(1e-9)) : thick;
}

void place_in_world(std::vector<GltfNode>& nodes) {
    for (GltfNode& node : nodes) {
        const dmat4 own = node.place.parent_from_node();
        node.world_from_node =
            node.parent == GltfNode::no_parent ? own : nodes[node.parent].world_from_node * own;
    }
}

std::vector<GltfNode> placed_nodes(const GltfDocument& document) {
    std::vector<GltfNode> placed, waiting;
    std::vector<bool> is_placed(document.count("nodes"), false);
    const auto wait = [&](const std::vector<std::size_t>& nodes, std::size_t parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            waiting.push_back({.index = *node, .parent = parent});
    };
    wait(roots_of(document), GltfNode::no_parent);
    while (!waiting.empty()) {
        GltfNode& node = placed.emplace_back(std::move(waiting.back()));
        waiting.pop_back();
        const JsonValue json = document.root().at("nodes")[node.index];
        if (is_placed[node.index])
            json.fail("has two parents, or is in a circle; expected a tree of nodes");
        is_placed[node.index] = true;
        node.place = place_of(json);
        if (const auto children = json.find("children")) {
            std::vector<std::size_t> indices;
            for (std::size_t k = 0; k < children->size(); ++k)
                indices.push_back((*children)[k].whole(0, is_placed.size() - 1));
            wait(indices, placed.size() - 1);
        }
    }
    place_in_world(placed);
    for (const GltfNode& node : placed)
        for (int i = 0; i < 16; ++i)
            if (!placeable.contains(node.world_from_node[i / 4][i % 4]))
                document.root().at("nodes")[node.index].fail(
                    "lies beyond 1e18, its parents included; expected less");
    return placed;
}

std::vector<std::size_t> places_of(const GltfDocument& document,
                                   const std::vector<GltfNode>& nodes) {
    std::vector<std::size_t> places(document.count("nodes"), GltfNode::no_parent);
    for (std::size_t i = 0; i < nodes.size(); ++i) places[nodes[i].index] = i;
    return places;
}

std::vector<dmat4> instances_of(const GltfDocument& document, const JsonValue& node,
                                std::size_t most) {
    const auto extensions = node.find("extensions");
    const auto extension = extensions ? extensions->find("EXT_mesh_gpu_instancing") : std::nullopt;
    if (!extension) return {dmat4(1)};
    const JsonValue attributes = extension->at("attributes");
    std::vector<GltfPlace> places;
    const auto read = [&](const char* name, const char* type, const auto& set) {
        const auto value = attributes.find(name);
        if (!value) return;
        const std::size_t count = count_of(document, *value);
        if (places.empty()) {
            if (count > most)
                value->fail("has " + std::to_string(count) + " elements; expected at most " +
                            std::to_string(most));
            places.resize(count);
        }
        if (count != places.size())
            value->fail("has " + std::to_string(count) + " elements; expected " +
                        std::to_string(places.size()) + ", as the others have");
        const Elements<float> numbers = read_floats(document, *value, {type});
        for (std::size_t i = 0; i < count; ++i) set(places[i], numbers[i]);
    };
    read("TRANSLATION", "VEC3", [](GltfPlace& place, const float* v) {
        place.translation = {v[0], v[1], v[2]};
    });
    read("ROTATION", "VEC4", [](GltfPlace& place, const float* v) {
        const dvec4 q(v[0], v[1], v[2], v[3]);
        if (const double size = std::sqrt(dot4(q, q)); size > 0) place.rotation = q / size;
    });
    read("SCALE", "VEC3", [](GltfPlace& place, const float* v) {
        place.scale = {v[0], v[1], v[2]};
    });
    std::vector<dmat4> instances;
    for (const GltfPlace& place : places) instances.push_back(place.parent_from_node());
    return instances;
}

GltfSkin read_gltf_skin(const GltfDocument& document, const JsonValue& index,
                        const std::vector<std::size_t>& places) {
    const JsonValue json = document.element("skins", index), joints = json.at("joints");
    GltfSkin skin;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        skin.joints.push_back(places[joints[i].whole(0, places.size() - 1)]);
        if (skin.joints.back() == GltfNode::no_parent)
            joints[i].fail("is not in the scene; expected a node of it");
    }
    skin.joint_from_rest.resize(joints.size(), dmat4(1));
    const auto matrices = json.find("inverseBindMatrices");
    if (!matrices) return skin;
    const Elements<float> read = read_floats(document, *matrices, {"MAT4"});
    if (read.count() < joints.size())
        matrices->fail("has " + std::to_string(read.count()) + " elements; expected " +
                       std::to_string(joints.size()) + ", one for each joint");
    for (std::size_t i = 0; i < joints.size(); ++i)
        for (int k = 0; k < 12; ++k)  // columns; the last row is 0, 0, 0, 1
            skin.joint_from_rest[i][k / 3][k % 3] = double(read[i][k / 3 * 4 + k % 3]);
    return skin;
}

}  // namespace gw::scene
