#include "render/study/divided.h"

#include "scene/scene_builder.h"

#include <algorithm>
#include <unordered_map>

namespace gw::render {
namespace {

class Divider {
public:
    explicit Divider(const Mesh& mesh) : data_(mesh.data()) {
        data_.primitive = Primitive::Triangles;
        data_.indices.clear();
        for (const Triangle& t : mesh.triangles())
            data_.indices.insert(data_.indices.end(), t.vertex.begin(), t.vertex.end());
        data_.polygon_sizes.clear();
        data_.polygon_ids.clear();
        data_.edge_flags.clear();
    }

    void divide() {
        middles_.clear();
        std::vector<std::uint32_t> indices;
        indices.reserve(4 * data_.indices.size());
        for (std::size_t i = 0; i < data_.indices.size(); i += 3) {
            const std::uint32_t a = data_.indices[i], b = data_.indices[i + 1],
                                c = data_.indices[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::uint32_t v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca})
                indices.push_back(v);
        }
        data_.indices = std::move(indices);
    }
    MeshData take() { return std::move(data_); }

private:
    template <class Value>
    static void add_middle(std::vector<Value>& values, std::uint32_t a, std::uint32_t b) {
        if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5f);
    }

    /// The vertex between the two, in either order.
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t side = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        const auto [place, is_new] =
            middles_.try_emplace(side, std::uint32_t(data_.positions.size()));
        if (!is_new) return place->second;
        add_middle(data_.positions, a, b);
        add_middle(data_.normals, a, b);
        add_middle(data_.texcoords, a, b);
        add_middle(data_.colors, a, b);
        add_middle(data_.w, a, b);
        add_middle(data_.texcoords_rq, a, b);
        if (!data_.material_indices.empty())
            data_.material_indices.push_back(data_.material_indices[a]);
        return place->second;
    }

    MeshData data_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

}  // namespace

scene::Scene divided(scene::Scene scene, int times) {
    if (times == 0) return scene;
    std::uint32_t next = 0;
    std::unordered_map<const Mesh*, MeshRef> done;
    for (scene::Object& object : scene.objects) {
        MeshRef& mesh = done[object.mesh.get()];
        if (!mesh) {
            MeshData data = object.mesh->data();
            data.polygon_ids.clear();
            if (object.mesh->kind() == MeshKind::Triangles) {
                Divider divider(*object.mesh);
                for (int k = 0; k < times; ++k) divider.divide();
                data = divider.take();
            }
            mesh = scene::make_numbered_mesh(std::move(data), next);
        }
        object.mesh = mesh;
    }
    return scene;
}

}  // namespace gw::render
