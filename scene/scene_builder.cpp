#include "scene/scene_builder.h"

#include "gw/error.h"
#include "scene/geometry/polygon_ids.h"
#include "scene/text/suggest.h"

namespace gw::scene {

void SceneBuilder::add(Object object, MeshData mesh, const Material& material,
                       const Origin& origin) {
    try {
        object.mesh = make_numbered_mesh(std::move(mesh), next_polygon_);
    } catch (const Error& error) {
        throw Error(origin.file, origin.line, error.what());
    }
    object.material = index_of(material);
    scene.objects.push_back(std::move(object));
}

std::size_t SceneBuilder::index_of(const Material& material) {
    const auto [found, is_new] = indices_.try_emplace(&material, scene.materials.size());
    if (is_new) scene.materials.push_back(material);
    return found->second;
}

const Material& default_material() {
    static const Material material{.name = "default"};
    return material;
}

const Material& find_material(std::initializer_list<const std::vector<Material>*> lists,
                              std::string_view name, const Origin& origin) {
    if (name.empty()) return default_material();
    std::vector<std::string> known;
    for (const std::vector<Material>* list : lists)
        for (const Material& material : *list) {
            if (material.name == name) return material;
            known.push_back(material.name);
        }
    throw Error(origin.file, origin.line, unknown("material", name, known));
}

}  // namespace gw::scene
