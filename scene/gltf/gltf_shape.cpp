#include "scene/gltf/gltf_shape.h"

#include "gw/base/arithmetic.h"
#include "scene/geometry/transform.h"
#include "scene/gltf/gltf_material.h"
#include "scene/maps/map_lists.h"
#include "scene/maps/patches.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

namespace gw::scene {
namespace {

/// The corners of triangle i of a strip or a fan, in the orientation of the first.
std::array<std::size_t, 3> corners_of(Primitive primitive, std::size_t i) {
    if (primitive == Primitive::TriangleFan) return {0, i + 1, i + 2};
    if (primitive == Primitive::TriangleStrip)
        return i % 2 == 0 ? std::array{i, i + 1, i + 2} : std::array{i + 1, i, i + 2};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

std::array<std::uint32_t, 3> triangle_of(const MeshData& mesh, std::size_t i) {
    std::array<std::uint32_t, 3> at{};
    const std::array<std::size_t, 3> places = corners_of(mesh.primitive, i);
    for (std::size_t k = 0; k < 3; ++k)
        at[k] = mesh.indices.empty() ? std::uint32_t(places[k]) : mesh.indices[places[k]];
    return at;
}

constexpr std::size_t most_patches = std::size_t{1} << 18;

Patches color_patches(std::size_t triangles) {
    return {triangles, std::size_t(triangles <= 1024 ? 8 : 4)};
}

/// Triangles of nearly one colour.
struct ColorGroup {
    std::vector<std::uint32_t> corners;
    dvec3 sum{0};  ///< of the triangles' means
};
using ColorGroups = std::map<std::array<int, 3>, ColorGroup>;

/// By the triangles' means, in the finest steps that leave at most 64 groups.
ColorGroups color_groups(const GltfMesh& mesh) {
    constexpr std::size_t most_groups = 64;
    ColorGroups groups;
    for (int steps = 255; steps > 0; steps /= 2) {
        groups.clear();
        for (std::size_t i = 0; i < triangle_count(mesh.mesh) && groups.size() <= most_groups;
             ++i) {
            const std::array<std::uint32_t, 3> at = triangle_of(mesh.mesh, i);
            const dvec3 mean = glm::clamp(
                dvec3(vec3(mesh.colors[at[0]] + mesh.colors[at[1]] + mesh.colors[at[2]])) / 3.0,
                dvec3(0), dvec3(1));
            std::array<int, 3> cell{};
            for (int k = 0; k < 3; ++k) cell[std::size_t(k)] = int(std::lround(mean[k] * steps));
            ColorGroup& group = groups[cell];
            group.corners.insert(group.corners.end(), at.begin(), at.end());
            group.sum += mean;
        }
        if (groups.size() <= most_groups) break;
    }
    return groups;
}

/// The triangles of these corners, with only their vertices.
GltfMesh part_of(const GltfMesh& whole, const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> kept = corners;
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    const auto picked = [&](const auto& list, std::size_t each = 1) {
        std::decay_t<decltype(list)> part;
        if (list.empty()) return part;
        part.reserve(kept.size() * each);
        for (const std::uint32_t vertex : kept)
            part.insert(part.end(), list.begin() + std::ptrdiff_t(vertex * each),
                        list.begin() + std::ptrdiff_t((vertex + 1) * each));
        return part;
    };
    GltfMesh part{.mean_color = whole.mean_color,
                  .colors = picked(whole.colors),
                  .influences = whole.influences,
                  .influenced = picked(whole.influenced, whole.influences),
                  .joints = whole.joints};
    part.mesh = {.positions = picked(whole.mesh.positions),
                 .normals = picked(whole.mesh.normals),
                 .texcoords = picked(whole.mesh.texcoords)};
    part.other_texcoords = picked(whole.other_texcoords);
    part.mesh.colors = picked(whole.mesh.colors);
    for (const std::uint32_t corner : corners)
        part.mesh.indices.push_back(
            std::uint32_t(std::ranges::lower_bound(kept, corner) - kept.begin()));
    for (const MorphTarget& target : whole.targets)
        part.targets.push_back({picked(target.positions), picked(target.normals)});
    return part;
}

/// The matrix of normals, on the side where the surface's is.
dmat3 normals_from(const dmat3& m) {
    const dmat3 cofactors(cross3(m[1], m[2]), cross3(m[2], m[0]), cross3(m[0], m[1]));
    return dot3(m[0], cofactors[0]) < 0 ? -cofactors : cofactors;
}

}  // namespace

std::size_t triangle_count(const MeshData& mesh) {
    const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    switch (mesh.primitive) {
        case Primitive::Triangles: return corners / 3;
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan: return corners < 3 ? 0 : corners - 2;
        case Primitive::Points:
        case Primitive::Lines:
        case Primitive::LineStrip:
        case Primitive::Quads:
        case Primitive::Polygons: break;
    }
    return 0;
}

bool has_color_texture(const GltfMesh& mesh) {
    const std::size_t triangles = triangle_count(mesh.mesh);
    return !mesh.colors.empty() && triangles > 0 && triangles <= most_patches;
}

// Colours beyond the third side go on in the triangle's plane, so that its texels are interpolated to
// its own colours.
TextureRef color_texture(const GltfMesh& mesh) {
    const std::size_t triangles = triangle_count(mesh.mesh);
    const Patches patches = color_patches(triangles);
    std::vector<std::uint16_t> rgba(4 * patches.width() * patches.height(), 0xFFFF);
    const double last = double(patches.side) - 1;
    for (std::size_t i = 0; i < triangles; ++i) {
        const std::array<std::uint32_t, 3> at = triangle_of(mesh.mesh, i);
        const dvec3 a(vec3(mesh.colors[at[0]])), u = dvec3(vec3(mesh.colors[at[1]])) - a,
                                                 v = dvec3(vec3(mesh.colors[at[2]])) - a;
        const std::size_t column = patches.column(i), row = patches.row(i);
        for (std::size_t y = 0; y < patches.side; ++y)
            for (std::size_t x = 0; x < patches.side; ++x) {
                const dvec3 color = a + u * (double(x) / last) + v * (double(y) / last);
                const vec3 shown = encoded(glm::clamp(color, dvec3(0), dvec3(1)));
                std::uint16_t* const texel = &rgba[4 * ((row + y) * patches.width() + column + x)];
                for (int k = 0; k < 3; ++k)
                    texel[k] = std::uint16_t(quantize(double(shown[k]), 16));
            }
    }
    return make_texture("vertex colours", int(patches.width()), int(patches.height()), rgba);
}

std::size_t patch_colors(GltfMesh& mesh) {
    const Patches patches = color_patches(triangle_count(mesh.mesh));
    mesh.patch_side = patches.side;
    return patches.width() * patches.height();
}

std::size_t patch_maps(GltfMesh& mesh, Material& material, std::size_t texels) {
    const std::size_t triangles = triangle_count(mesh.mesh);
    if (triangles == 0 || mesh.mesh.texcoords.empty() || mesh.other_texcoords.empty()) return 0;
    mesh.patch_side = patch_side(triangles, texels);
    if (mesh.patch_side == 0) return 0;
    const Patches patches(triangles, mesh.patch_side);
    const auto lookup_of = [&](const std::vector<vec2>& st) {
        PatchedLookup lookup{patches, {}};
        for (std::size_t i = 0; i < triangles; ++i)
            for (const std::uint32_t corner : triangle_of(mesh.mesh, i))
                lookup.st.push_back(st[corner]);
        return std::make_shared<const PatchedLookup>(std::move(lookup));
    };
    const auto own = lookup_of(mesh.mesh.texcoords), other = lookup_of(mesh.other_texcoords);
    for_each_map_list(material, [&](std::string_view, std::vector<Map>& maps) {
        for (Map& map : maps) map.patched = std::exchange(map.is_mean, false) ? other : own;
    });
    return patches.width() * patches.height();
}

std::vector<GltfMesh> by_color(GltfMesh mesh) {
    if (mesh.colors.empty() || triangle_count(mesh.mesh) == 0) return {std::move(mesh)};
    std::vector<GltfMesh> meshes;
    for (const auto& [cell, group] : color_groups(mesh)) {
        const vec3 color(glm::round(group.sum / double(group.corners.size() / 3) * 255.0) / 255.0);
        bool varies = false;
        for (const std::uint32_t corner : group.corners)
            for (int k = 0; k < 3; ++k)
                varies |= std::abs(mesh.colors[corner][k] - color[k]) > 1.0f / 16;
        GltfMesh& one = meshes.emplace_back(part_of(mesh, group.corners));
        if (!varies) one.colors.clear();
        one.mean_color = vec4(color, mesh.mean_color->w);
    }
    return meshes;
}

std::optional<MeshData> moved(const GltfMesh& mesh, std::span<const double> weights,
                              std::span<const dmat4> object_from_rest) {
    MeshData out = mesh.mesh;
    const std::size_t targets = std::min(weights.size(), mesh.targets.size());
    const bool has_normals = !out.normals.empty();
    for (std::size_t i = 0; i < out.positions.size(); ++i) {
        dvec3 p(out.positions[i]), n = has_normals ? dvec3(out.normals[i]) : dvec3(0);
        for (std::size_t t = 0; t < targets; ++t) {
            const MorphTarget& target = mesh.targets[t];
            if (!target.positions.empty()) p += weights[t] * dvec3(target.positions[i]);
            if (has_normals && !target.normals.empty()) n += weights[t] * dvec3(target.normals[i]);
        }
        if (!object_from_rest.empty() && mesh.influences > 0) {
            dmat4 m(0);
            for (std::size_t k = 0; k < mesh.influences; ++k) {
                const Influence& by = mesh.influenced[i * mesh.influences + k];
                m += object_from_rest[by.joint] * double(by.weight);
            }
            p = transform3(dmat3(m), p) + dvec3(m[3]);
            n = transform3(normals_from(dmat3(m)), n);
        }
        for (int k = 0; k < 3; ++k)
            if (!placeable.contains(p[k])) return std::nullopt;
        out.positions[i] = vec3(p);
        if (!has_normals) continue;
        const double size = length(n);
        out.normals[i] = size > 0 && std::isfinite(size) ? vec3(n / size) : vec3(0, 0, 1);
    }
    return out;
}

MeshData drawn(const GltfMesh& mesh, MeshData moved) {
    const std::size_t triangles = triangle_count(moved);
    const bool is_flat = moved.normals.empty();
    if (triangles == 0 || (!is_flat && mesh.patch_side == 0)) return moved;
    const Patches patches(triangles, mesh.patch_side);
    MeshData out;
    for (std::size_t i = 0; i < triangles; ++i) {
        const std::array<std::uint32_t, 3> at = triangle_of(moved, i);
        const dvec3 a(moved.positions[at[0]]);
        const dvec3 n =
            cross3(dvec3(moved.positions[at[1]]) - a, dvec3(moved.positions[at[2]]) - a);
        const vec3 normal = n == dvec3(0) ? vec3(0, 0, 1) : vec3(n / length(n));
        for (std::size_t k = 0; k < 3; ++k) {
            out.positions.push_back(moved.positions[at[k]]);
            out.normals.push_back(is_flat ? normal : moved.normals[at[k]]);
            if (!moved.colors.empty()) out.colors.push_back(moved.colors[at[k]]);
            if (mesh.patch_side > 0)
                out.texcoords.push_back(patches.st(i, k));
            else if (!moved.texcoords.empty())
                out.texcoords.push_back(moved.texcoords[at[k]]);
        }
    }
    return out;
}

std::optional<MeshData> posed(const GltfShaped& shaped, const std::vector<GltfNode>& nodes,
                              const std::vector<std::uint32_t>& polygon_ids) {
    std::vector<dmat4> object_from_rest;
    if (shaped.skin)
        for (std::size_t j = 0; j < shaped.skin->joints.size(); ++j)
            object_from_rest.push_back(
                translation(-shaped.base) *
                (nodes[shaped.skin->joints[j]].world_from_node * shaped.skin->joint_from_rest[j]));
    std::optional<MeshData> mesh = moved(*shaped.mesh, shaped.weights, object_from_rest);
    if (!mesh) return std::nullopt;
    *mesh = drawn(*shaped.mesh, *std::move(mesh));
    mesh->polygon_ids = polygon_ids;
    return mesh;
}

}  // namespace gw::scene
