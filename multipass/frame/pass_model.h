// A scene made ready to be drawn in passes: every object with its maps by component, textures
// looked up, meshes with their maps' scale and offset. Made once per scene. Does not place anything
// before an eye: placed_model.h does.
#pragma once

#include "gw/command_list.h"
#include "multipass/passes/pass.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace gw::multipass {

/// One map of one component on one object.
struct MappedMesh {
    MeshRef mesh;
    TextureRef texture;
    TextureState lookup;
};

/// An object of the scene.
struct Part {
    const scene::Object* object = nullptr;
    const scene::Material* material = nullptr;
    MeshRef mesh;  ///< for passes without a map
    bool translucent = false;
    std::array<std::vector<MappedMesh>, 8> maps;  ///< by PassMap

    const std::vector<MappedMesh>& maps_for(PassMap map) const { return maps[std::size_t(map)]; }
};

/// Refers to the scene, which must outlive it.
struct Model {
    const scene::Scene* scene = nullptr;
    std::vector<Part> parts;  ///< by object
};

Model make_model(const scene::Scene& scene);

/// The material that a pass sets for an object [K3p]; its alpha stays the object's.
Material material_for(const PassMaterial& set, const scene::Material& material);

/// The largest number of maps that any object has for a component, at least 1: so often is its pass
/// repeated [K3.1].
std::size_t repetitions(const Model& model, PassMap map);

}  // namespace gw::multipass
