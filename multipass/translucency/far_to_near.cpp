#include "multipass/translucency/far_to_near.h"

#include <algorithm>

namespace gw::multipass {
namespace {

struct SortedTriangle {
    double distance = 0;  ///< three times the centroid's
    std::size_t part = 0;
    std::uint32_t triangle = 0;
};

void add_triangles(std::vector<SortedTriangle>& all, const PlacedModel& placed, std::size_t index) {
    const Mesh& mesh = *placed.model->parts[index].mesh;
    const dmat4& m = placed.eye_from_object[index];
    const auto distance = [&](std::uint32_t vertex) {
        return -(transform3(dmat3(m), dvec3(mesh.data().positions[vertex])).z + m[3].z);
    };
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        const auto& v = mesh.triangles()[i].vertex;
        all.push_back({distance(v[0]) + distance(v[1]) + distance(v[2]), index, i});
    }
}

}  // namespace

std::vector<Portion> far_to_near(const PlacedModel& placed) {
    const auto& parts = placed.model->parts;
    std::vector<SortedTriangle> all;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].translucent && parts[i].mesh->kind() == MeshKind::Triangles)
            add_triangles(all, placed, i);
    std::stable_sort(all.begin(), all.end(), [](const SortedTriangle& a, const SortedTriangle& b) {
        return a.distance > b.distance;
    });
    std::vector<Portion> portions;
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(
            first, all.end(), [&](const SortedTriangle& p) { return p.part != first->part; });
        std::vector<std::uint32_t> triangles;
        for (auto p = first; p != last; ++p) triangles.push_back(p->triangle);
        portions.push_back(portion_of(placed, first->part, triangles));
        first = last;
    }
    return portions;
}

}  // namespace gw::multipass
