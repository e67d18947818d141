// Completes a scene: fits a camera, adds a light, applies the camera options of the command line.
// Does not draw, and changes nothing that a scene says itself.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace gw::scene {

/// Sees all of `bounds` from in front, a little from the right and above, as near as possible.
Camera fit_camera(const Bounds& bounds, int width, int height);

inline constexpr const char* default_light_name = "default";
/// A directional light over the viewer's left shoulder: Ia = 0.25, Id = Is = 0.8.
Light default_light(const Camera& camera);

/// Is anything in the scene a source of light?
bool glows(const Scene& scene);

/// Adds fit_camera to a scene without a camera, and default_light to one without lights in which
/// nothing emits.
void add_defaults(Scene& scene, int width, int height);

/// A picture's eye, at, up and fov, instead of the scene's.
struct CameraOverrides {
    std::optional<dvec3> eye, at, up;
    std::optional<double> fov;
};
Camera override_camera(Camera camera, const CameraOverrides& overrides);

/// Turns eye and up by `degrees` about the axis `up` through `at`, counter-clockwise seen from
/// above. 0 and 360 give the same camera.
Camera turntable(Camera camera, double degrees);

}  // namespace gw::scene
