// A TOML scene and its sections: camera, lights, fog, materials, placements. docs/scenes.md has every
// key. Objects, which read files, are in toml_objects.h.
#pragma once

#include "scene/text/warnings.h"
#include "scene/toml/read_scene.h"
#include "scene/toml/toml_binder.h"

namespace gw::scene {

/// The whole scene. Throws Error "file:line: what; expected what"; an unknown key names the nearest
/// known one. All functions below do.
SceneFile read_toml(const std::filesystem::path& path);

Camera to_camera(const TomlValue& table);

/// What of the scene a light's numbers need.
struct LightScene {
    double white;  ///< Scene::white
    Warnings& warnings;
    dvec3 origin = dvec3(0);  ///< positions are counted from it (scene/geometry/far.h)
};
Light to_light(const TomlValue& table, const LightScene& scene);
Fog to_fog(const TomlValue& table, Warnings& warnings);

/// Changes the fields of `material` whose keys the table has.
void read_material(const TomlValue& table, Material& material);

/// An object's place: `matrix`, or `scale`, then `rotate`, then `translate`.
struct Placement {
    const TomlValue *translate = nullptr, *rotate = nullptr, *scale = nullptr, *matrix = nullptr;
};
/// Appends the four keys that fill a placement in.
void add_placement_keys(std::vector<Key>& keys, Placement& placement);
dmat4 world_from_object(const Placement& placement);

}  // namespace gw::scene
