#include "scene/geometry/mirrored_faces.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace gw::scene {

bool is_mirrored(const dmat4& m) { return dot3(cross3(dvec3(m[0]), dvec3(m[1])), dvec3(m[2])) < 0; }

MeshData reversed(const Mesh& mesh) {
    MeshData data = mesh.data();
    if (mesh.kind() != MeshKind::Triangles) return data;
    std::vector<std::uint32_t>& indices = data.indices;
    if (data.primitive == Primitive::TriangleStrip || data.primitive == Primitive::TriangleFan) {
        data.primitive = Primitive::Triangles;
        indices.clear();
        for (const Triangle& t : mesh.triangles())
            indices.insert(indices.end(), {t.vertex[0], t.vertex[2], t.vertex[1]});
        return data;
    }
    if (indices.empty()) {
        indices.resize(data.positions.size());
        std::iota(indices.begin(), indices.end(), 0u);
    }
    const bool is_polygons = data.primitive == Primitive::Polygons;
    std::size_t face = 0;
    for (auto first = indices.begin(); first != indices.end(); ++face) {
        const std::size_t corners = data.primitive == Primitive::Triangles ? 3
                                    : !is_polygons                         ? 4
                                    : data.polygon_sizes.empty()           ? indices.size()
                                                                 : data.polygon_sizes[face];
        const auto last = first + std::ptrdiff_t(corners);
        std::reverse(first + 1, last);
        first = last;
    }
    return data;
}

void reverse_mirrored(Scene& scene) {
    std::map<MeshRef, MeshRef> made;
    for (Object& object : scene.objects) {
        if (!object.mesh || !is_mirrored(object.world_from_object)) continue;
        MeshRef& mesh = made[object.mesh];
        if (!mesh) mesh = make_mesh(reversed(*object.mesh));
        object.mesh = mesh;
    }
}

}  // namespace gw::scene
