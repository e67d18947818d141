#include "scene/scene_builder.h"

#include "gw/error.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <numeric>

namespace gw::scene {
namespace {

std::size_t polygon_count(const MeshData& data) {
    const std::size_t n = data.indices.empty() ? data.positions.size() : data.indices.size();
    switch (data.primitive) {
        case Primitive::Points: return n;
        case Primitive::Lines: return n / 2;
        case Primitive::LineStrip: return n < 2 ? 0 : n - 1;
        case Primitive::Triangles: return n / 3;
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan: return n < 3 ? 0 : n - 2;
        case Primitive::Quads: return n / 4;
        case Primitive::Polygons: return data.polygon_sizes.empty() ? 1 : data.polygon_sizes.size();
    }
    return 0;
}

}  // namespace

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

bool without_highlights(Material& material) {
    if (material.illum > 1 || material.Ks == vec3(0) || !material.refl.empty()) return false;
    material.Ks = vec3(0);
    material.map_Ks.clear();
    return true;
}

void warn_invisible(const Scene& scene, const std::string& file, Warnings& warnings) {
    for (const Material& material : scene.materials)
        if (material.d == 0 &&
            material.illum < 3)  // above, rays show what it reflects and refracts
            warnings.add(file, 0, "invisible " + material.name,
                         "material '" + printable(material.name) +
                             "' is invisible (d 0, or Tr 1); expected d above 0");
}

void MaterialLibrary::add(MaterialLibrary more) {
    for (auto& [name, fault] : more.faults)
        if (std::ranges::find(materials, name, &Material::name) == materials.end())
            faults.try_emplace(name, std::move(fault));
    for (Material& material : more.materials) materials.push_back(std::move(material));
}

MaterialNames::MaterialNames(const MaterialLibrary& library, std::string missing)
    : library_(&library), missing_(std::move(missing)) {
    for (const Material& material : list()) by_name_.try_emplace(material.name, &material);
}

const Material* MaterialNames::find(std::string_view name) const {
    if (const auto fault = library_->faults.find(name); fault != library_->faults.end())
        throw Error(fault->second);
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : found->second;
}

namespace {

/// Null if there is none.
const Material* known_material(std::initializer_list<const MaterialNames*> lists,
                               std::string_view name) {
    if (name.empty()) return &default_material();
    for (const MaterialNames* names : lists)
        if (const Material* material = names->find(name)) return material;
    return nullptr;
}

std::string unknown_material(std::initializer_list<const MaterialNames*> lists,
                             std::string_view name) {
    std::vector<std::string> known;
    std::string missing;
    for (const MaterialNames* names : lists) {
        for (const Material& material : names->list()) known.push_back(material.name);
        if (!names->missing().empty()) missing += " (" + names->missing() + ")";
    }
    return unknown("material", name, known) + missing;
}

}  // namespace

const Material& find_material(std::initializer_list<const MaterialNames*> lists,
                              std::string_view name, const Origin& origin) {
    if (const Material* const material = known_material(lists, name)) return *material;
    throw Error(origin.file, origin.line, unknown_material(lists, name));
}

const Material& material_of_faces(std::initializer_list<const MaterialNames*> lists,
                                  std::string_view name, const Origin& origin, Warnings& warnings) {
    if (const Material* const material = known_material(lists, name)) return *material;
    // Without any material, all names of the file have one reason.
    const bool none = std::ranges::all_of(lists, [](auto* names) { return names->list().empty(); });
    warnings.add(origin.file, origin.line, none ? "usemtl" : "usemtl " + std::string(name),
                 unknown_material(lists, name) + "; the default one stands in");
    return default_material();
}

MeshRef make_numbered_mesh(MeshData data, std::uint32_t& next) {
    data.polygon_ids.resize(polygon_count(data));
    std::iota(data.polygon_ids.begin(), data.polygon_ids.end(), next);
    next += static_cast<std::uint32_t>(data.polygon_ids.size());
    return make_mesh(std::move(data));
}

}  // namespace gw::scene
