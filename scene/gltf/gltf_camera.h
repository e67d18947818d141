// Cameras and punctual lights at their nodes [GLTF2 3.10, KHR_lights_punctual]. Does not find nodes.
#pragma once

#include "scene/gltf/gltf_document.h"
#include "scene/scene.h"

namespace gw::scene {

/// The camera of a value of `cameras`, placed by its node.
Camera read_gltf_camera(const JsonValue& camera, const dmat4& world_from_node);

/// Moves a camera to its node.
void place_camera(Camera& camera, const dmat4& world_from_node);
/// The way in which a node's light travels.
vec3 light_direction(const dmat4& world_from_node);

/// A light whose place is in double, until the scene's origin is known.
struct GltfLight {
    Light light;  ///< without position; Id is linear, an illuminance / pi
    dvec3 position{0};
};

/// The light of a value of KHR_lights_punctual's `lights`, placed by its node.
GltfLight read_gltf_light(const GltfDocument& document, const JsonValue& light,
                          const dmat4& world_from_node, const std::string& name);

struct ExposedLights {
    std::vector<Light> lights;
    double white = 0;  ///< Scene::white, in lux; 0: no lights
};

/// Encodes the lights' intensities as colours are: pi lux are white. If bright surfaces of `scene` get
/// more, all are divided by one number first, with a warning, and so many times pi lux are white.
/// Points and spots keep their candela as Luminous.
ExposedLights exposed(const GltfDocument& document, const std::vector<GltfLight>& lights,
                      const Scene& scene);

}  // namespace gw::scene
