#include "gw/fast/vertices/project_parts.h"

#include "gw/base/prefetch.h"

#include <algorithm>

namespace gw::fast {
namespace {

bool is_projected_together(const Mesh& mesh) {
    return mesh.vertex_count() <= 32 && mesh.data().w.empty();
}

/// The end of the parts from `first` on that are projected together.
std::size_t end_together(std::span<const GeometryPart> parts, std::size_t first) {
    const std::size_t most = std::min(parts.size(), first + 32);
    std::size_t i = first;
    while (i < most && is_projected_together(*parts[i].mesh) &&
           parts[i].eye_from_object == parts[first].eye_from_object)
        ++i;
    return std::max(i, first + 1);
}

[[gnu::always_inline]] inline void prefetch_part(std::span<const GeometryPart> parts,
                                                 std::size_t i) {
    if (i >= parts.size()) return;
    prefetch_elements(parts[i].mesh->data().positions);
    prefetch_elements(parts[i].mesh->triangles());
}

}  // namespace

void PartProjector::use_transform() {
    const dmat4& eye_from_object = set.parts[part].eye_from_object;
    projection.clip_from_object = product(set.state.projection, eye_from_object);
    projection.eye_from_object = eye_from_object;
}

void PartProjector::add() {
    if (part == end) {
        end = end_together(set.parts, part);
        together = end > part + 1;
        use_transform();
        if (together) project_together();
    }
    if (together)
        take_vertices(set.parts[part].mesh->vertex_count());
    else
        project_part();
    part += 1;
}

void PartProjector::project_part() {
    prefetch_part(set.parts, part + 3);
    const MeshData& mesh = set.parts[part].mesh->data();
    const std::size_t base = set.at.size();
    set.at.resize(base + mesh.positions.size());
    set.w.resize(base + mesh.positions.size());
    scratch.outcode.resize(mesh.positions.size());
    outcode = scratch.outcode.data();
    project(projection,
            {mesh.positions, mesh.w, scratch.outcode.data(), &set.at[base], &set.w[base]});
}

void PartProjector::project_together() {
    std::vector<vec3>& all = scratch.positions;
    all.clear();
    for (std::size_t i = part; i < end; ++i) {
        prefetch_part(set.parts, i + 4);
        const std::vector<vec3>& positions = set.parts[i].mesh->data().positions;
        all.insert(all.end(), positions.begin(), positions.end());
    }
    scratch.outcode.resize(all.size());
    scratch.at.resize(all.size());
    scratch.w.resize(all.size());
    vertex = 0;
    project(projection, {all, {}, scratch.outcode.data(), scratch.at.data(), scratch.w.data()});
}

void PartProjector::take_vertices(std::size_t count) {
    set.at.insert(set.at.end(), scratch.at.data() + vertex, scratch.at.data() + vertex + count);
    set.w.insert(set.w.end(), scratch.w.data() + vertex, scratch.w.data() + vertex + count);
    outcode = scratch.outcode.data() + vertex;
    vertex += count;
}

}  // namespace gw::fast
