#include "multipass/steps/pass_model.h"

#include "scene/draw/draw_commands.h"
#include "scene/draw/shading.h"
#include "scene/maps/alpha.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace gw::multipass {
namespace {

using scene::Component;

/// Meshes that a map's scale and offset changed, and textures, each made once.
class MapCache {
public:
    /// Passes multiply d by the alpha of a texture, which is no part of a surface's opacity.
    TextureRef texture(const scene::Map& map, const scene::Material& material) {
        return material.d < 1 ? opaque_.of(map.texture) : map.texture;
    }
    MeshRef mapped(const MeshRef& mesh, const scene::Map& map) {
        const Key key{mesh, map.scale.x, map.scale.y, map.offset.x, map.offset.y};
        MeshRef& made = meshes_[key];
        if (!made) made = scene::mapped_mesh(mesh, map);
        return made;
    }

private:
    using Key = std::tuple<MeshRef, float, float, float, float>;
    std::map<Key, MeshRef> meshes_;
    scene::OpaqueTextures opaque_;
};

TextureState lookup_of(const scene::Map& map, PassMap kind, const scene::Material& material) {
    TextureState state = scene::texture_state(map);
    if (kind == PassMap::Reflection) state.gen = TexGen::SphereMap;
    if (kind == PassMap::Refraction) {
        state.gen = TexGen::RefractionMap;
        state.eta = material.Ni > 0 ? 1.0 / material.Ni : 1.0;
    }
    if (state.gen != TexGen::None) state.wrap_s = state.wrap_t = Wrap::Clamp;
    return state;
}

Component component_of(PassMap map) {
    switch (map) {
        case PassMap::None: break;
        case PassMap::Ambient: return Component::Ambient;
        case PassMap::Diffuse: return Component::Diffuse;
        case PassMap::Specular: return Component::Specular;
        case PassMap::Emission: return Component::Emission;
        case PassMap::Reflection: return Component::Reflection;
        case PassMap::Refraction: return Component::Refraction;
        case PassMap::Object: break;
    }
    return Component::Diffuse;
}

PartMaps maps_of(const MeshRef& mesh, const scene::Material& material, MapCache& cache) {
    PartMaps maps;
    const auto add = [&](PassMap kind, const scene::Map& map) {
        maps[std::size_t(kind)].push_back({cache.mapped(mesh, map), cache.texture(map, material),
                                           lookup_of(map, kind, material)});
    };
    for (const PassMap kind : {PassMap::Ambient, PassMap::Diffuse, PassMap::Specular,
                               PassMap::Emission, PassMap::Reflection, PassMap::Refraction})
        for (const scene::Map& map : scene::maps(material, component_of(kind))) add(kind, map);
    if (const scene::Map* map = scene::hardware_map(material)) add(PassMap::Object, *map);
    return maps;
}

/// One mesh for all passes if the maps allow it: passes that share a mesh share its geometry.
MeshRef mesh_of(const Part& part) {
    for (const auto& list : *part.maps)
        for (const MappedMesh& map : list)
            if (map.mesh != part.object->mesh) return map.mesh;
    return part.object->mesh;
}

vec3 value_of(const Parameter& p, const vec3& objects, const scene::Material& m) {
    switch (p.kind) {
        case Parameter::Kind::Value: return {p.value[0], p.value[1], p.value[2]};
        case Parameter::Kind::Object: return objects;
        case Parameter::Kind::ObjectKs: return m.Ks;
        case Parameter::Kind::ObjectTf: return m.Tf;
    }
    return objects;
}

}  // namespace

PassModel make_pass_model(const scene::Scene& scene) {
    PassModel model{.scene = &scene};
    MapCache cache;
    std::map<std::pair<const Mesh*, std::size_t>, std::shared_ptr<const PartMaps>> maps;
    std::map<const Mesh*, scene::Bounds> boxes;
    model.parts.reserve(scene.objects.size());
    for (const scene::Object& item : scene.objects) {
        Part part{.object = &item, .material = &scene.materials.at(item.material)};
        part.translucent = part.material->d < 1;
        auto& shared = maps[{item.mesh.get(), item.material}];
        if (!shared)
            shared = std::make_shared<const PartMaps>(maps_of(item.mesh, *part.material, cache));
        part.maps = shared;
        part.mesh = mesh_of(part);
        const auto [box, is_new] = boxes.try_emplace(part.mesh.get());
        if (is_new)
            for (const vec3& p : part.mesh->data().positions) scene::extend(box->second, dvec3(p));
        part.box = box->second;
        model.parts.push_back(std::move(part));
    }
    return model;
}

Material material_for(const PassMaterial& set, const scene::Material& m) {
    return {.Ka = value_of(set.Ka, m.Ka, m),
            .Kd = value_of(set.Kd, m.Kd, m),
            .Ks = value_of(set.Ks, m.Ks, m),
            .Ke = value_of(set.Ke, m.Ke, m),
            .Ns = m.Ns,
            .alpha = m.d};
}

std::size_t repetitions(const PassModel& model, PassMap map) {
    std::size_t most = 1;
    for (const Part& part : model.parts) most = std::max(most, part.maps_for(map).size());
    return most;
}

}  // namespace gw::multipass
