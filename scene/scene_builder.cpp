#include "scene/scene_builder.h"

#include "gw/error.h"
#include "scene/geometry/polygon_ids.h"
#include "scene/text/suggest.h"

namespace gw::scene {

void SceneBuilder::add(Object object, MeshData mesh, const Material& material,
                       const Origin& origin) {
    object.mesh = numbered(std::move(mesh), origin);
    object.material = index_of(material);
    scene.objects.push_back(std::move(object));
}

MeshRef SceneBuilder::numbered(MeshData mesh, const Origin& origin) {
    try {
        return make_numbered_mesh(std::move(mesh), next_polygon_);
    } catch (const Error& error) {
        throw Error(origin.file, origin.line, error.what());
    }
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

MaterialNames::MaterialNames(const std::vector<Material>& list) : list_(&list) {
    for (const Material& material : list) by_name_.try_emplace(material.name, &material);
}

const Material* MaterialNames::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : found->second;
}

const Material& find_material(std::initializer_list<const MaterialNames*> lists,
                              std::string_view name, const Origin& origin) {
    if (name.empty()) return default_material();
    for (const MaterialNames* names : lists)
        if (const Material* material = names->find(name)) return *material;
    std::vector<std::string> known;
    for (const MaterialNames* names : lists)
        for (const Material& material : names->list()) known.push_back(material.name);
    throw Error(origin.file, origin.line, unknown("material", name, known));
}

}  // namespace gw::scene
