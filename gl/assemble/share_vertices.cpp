#include "gl/assemble/share_vertices.h"

#include <cstring>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gw::gl {

namespace {

void for_each_array(MeshData& mesh, const auto& visit) {
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.texcoords);
    visit(mesh.colors);
    visit(mesh.w);
    visit(mesh.texcoords_rq);
    for (UnitTexcoords& unit : mesh.more_texcoords) {
        visit(unit.st);
        visit(unit.rq);
    }
    visit(mesh.edge_flags);
    visit(mesh.material_indices);
    visit(mesh.secondary_colors);
    visit(mesh.fog_coordinates);
}

/// The bytes of each vertex's values, side by side.
struct VertexBytes {
    std::size_t size = 0;  ///< of a vertex
    std::vector<char> all;

    explicit VertexBytes(MeshData& mesh) {
        for_each_array(mesh, [&](auto& array) {
            if (!array.empty()) size += sizeof array[0];
        });
        all.resize(size * mesh.positions.size());
        std::size_t at = 0;
        for_each_array(mesh, [&](auto& array) {
            if (array.empty()) return;
            for (std::size_t i = 0; i < array.size(); ++i)
                std::memcpy(&all[i * size + at], &array[i], sizeof array[0]);
            at += sizeof array[0];
        });
    }
    std::string_view of(std::size_t vertex) const { return {&all[vertex * size], size}; }
};

}  // namespace

bool share_vertices(MeshData& mesh) {
    if (mesh.primitive < Primitive::Triangles) return false;
    const std::size_t count = mesh.positions.size();
    const VertexBytes bytes(mesh);
    std::unordered_map<std::string_view, std::uint32_t> number_of;
    number_of.reserve(count / 2);
    std::vector<std::uint32_t> shared(count), kept;
    for (std::size_t i = 0; i < count; ++i) {
        const auto next = static_cast<std::uint32_t>(kept.size());
        const auto [at, is_new] = number_of.try_emplace(bytes.of(i), next);
        shared[i] = at->second;
        if (!is_new) continue;
        if (2 * (kept.size() + 1) > count) return false;
        kept.push_back(static_cast<std::uint32_t>(i));
    }
    for_each_array(mesh, [&](auto& array) {
        if (array.empty()) return;
        for (std::size_t i = 0; i < kept.size(); ++i) array[i] = array[kept[i]];
        array.resize(kept.size());
        array.shrink_to_fit();
    });
    if (mesh.indices.empty()) {
        mesh.indices = std::move(shared);
        return true;
    }
    for (std::uint32_t& index : mesh.indices) index = shared[index];
    return true;
}

}  // namespace gw::gl
