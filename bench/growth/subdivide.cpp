#include "bench/growth/subdivide.h"

#include <array>
#include <map>
#include <utility>

namespace gw::growth {
namespace {

struct Subdivider {
    MeshData data;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles{};

    template <typename T>
    static void add_middle(std::vector<T>& values, std::uint32_t a, std::uint32_t b) {
        if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5f);
    }
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                      std::uint32_t(data.positions.size()));
        if (is_new) {
            add_middle(data.positions, a, b), add_middle(data.normals, a, b);
            add_middle(data.texcoords, a, b), add_middle(data.colors, a, b);
        }
        return at->second;
    }
    void cut(const std::array<std::uint32_t, 3>& v) {
        const std::uint32_t ab = middle(v[0], v[1]), bc = middle(v[1], v[2]),
                            ca = middle(v[2], v[0]);
        for (const std::uint32_t i : {v[0], ab, ca, ab, v[1], bc, ca, bc, v[2], ab, bc, ca})
            data.indices.push_back(i);
    }
};

}  // namespace

MeshRef subdivided(const Mesh& mesh) {
    Subdivider s{{.primitive = Primitive::Triangles,
                  .positions = mesh.data().positions,
                  .normals = mesh.data().normals,
                  .texcoords = mesh.data().texcoords,
                  .colors = mesh.data().colors}};
    for (const Triangle& t : mesh.triangles()) s.cut(t.vertex);
    return make_mesh(std::move(s.data));
}

}  // namespace gw::growth
