// The same triangles of every mesh that the part's maps have.
#include "multipass/frame/portion.h"

namespace gw::multipass {
namespace {

MeshRef pick(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const MeshData& from = mesh.data();
    MeshData to;
    const auto copy = [](const auto& source, auto& target, std::uint32_t i) {
        if (!source.empty()) target.push_back(source[i]);
    };
    for (const std::uint32_t triangle : triangles)
        for (const std::uint32_t v : mesh.triangles()[triangle].vertex) {
            to.positions.push_back(from.positions[v]);
            copy(from.normals, to.normals, v);
            copy(from.texcoords, to.texcoords, v);
            copy(from.colors, to.colors, v);
        }
    return make_mesh(std::move(to));
}

}  // namespace

Portion portion_of(const Stage& stage, std::size_t index,
                   std::span<const std::uint32_t> triangles) {
    Portion portion{.part = index};
    const auto add = [&](const MeshRef& mesh) {
        if (portion.of(mesh) == mesh) portion.meshes.emplace_back(mesh, pick(*mesh, triangles));
    };
    const Part& part = stage.model->parts[index];
    add(part.mesh);
    for (const auto& maps : part.maps)
        for (const MappedMesh& map : maps) add(map.mesh);
    return portion;
}

}  // namespace gw::multipass
