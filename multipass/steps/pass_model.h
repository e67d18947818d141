// A scene prepared for passes: every object with its maps by component, their textures, and meshes
// with the scale and offset of their maps. Made once per scene. Does not place anything before an
// eye (placed_model.h).
#pragma once

#include "gw/command_list.h"
#include "multipass/passes/pass.h"
#include "scene/scene.h"

#include <array>
#include <memory>
#include <vector>

namespace gw::multipass {

/// One map of one component on one object.
struct MappedMesh {
    MeshRef mesh;
    TextureRef texture;
    TextureState lookup;
};

/// The maps of an object, by PassMap.
using PartMaps = std::array<std::vector<MappedMesh>, 8>;

/// An object of the scene.
struct Part {
    const scene::Object* object = nullptr;
    const scene::Material* material = nullptr;
    MeshRef mesh;       ///< for passes without a map
    scene::Bounds box;  ///< of its mesh, in the object's coordinates
    bool translucent = false;
    std::shared_ptr<const PartMaps> maps;  ///< objects of one mesh and material share them

    const std::vector<MappedMesh>& maps_for(PassMap map) const { return (*maps)[std::size_t(map)]; }
};

/// Refers to the scene, which must outlive it.
struct PassModel {
    const scene::Scene* scene = nullptr;
    std::vector<Part> parts;  ///< by object
};

PassModel make_pass_model(const scene::Scene& scene);

/// The material that a pass sets for an object [K3p]; its alpha stays the object's.
Material material_for(const PassMaterial& set, const scene::Material& material);

/// The largest number of maps that any object has for a component, at least 1: its pass is repeated
/// that many times [K3.1].
std::size_t repetitions(const PassModel& model, PassMap map);

}  // namespace gw::multipass
