// A camera outside a scene that sees all of it.
#pragma once

#include "scene/draw/fit.h"

namespace gw::lab {

/// From the side of the scene's camera, from farther and higher. The scene has a camera.
inline scene::Camera outside_camera(const scene::Scene& scene) {
    const scene::Bounds bounds = scene::bounds(scene);
    scene::Camera far = *scene.camera;
    far.at = (bounds.low + bounds.high) * 0.5;
    const dvec3 away = scene.camera->eye - far.at;
    const double distance = glm::length(away) + glm::length(bounds.high - bounds.low);
    const dvec3 side = glm::normalize(away) + glm::normalize(glm::cross(far.up, away)) * 0.9 +
                       glm::normalize(far.up) * 0.5;
    far.eye = far.at + glm::normalize(side) * distance;
    far.aperture = far.near_plane = far.far_plane = 0;
    return far;
}

}  // namespace gw::lab
