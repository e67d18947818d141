// What a scene leaves open: a camera that sees all of it, a light, and the command line's changes
// to the camera. Does not draw, and changes nothing that a scene says itself.
#pragma once

#include "scene/scene.h"

#include <optional>

namespace gw::scene {

/// From in front, a little from the right and above, as near as the whole of `bounds` stays in the
/// window.
/// Any scale.
Camera fit_camera(const Bounds& bounds, int width, int height);

/// A directional light over the viewer's left shoulder: Ia = 0.25, Id = Is = 0.8.
Light default_light(const Camera& camera);

/// fit_camera where the scene has no camera; default_light where it has no light and nothing in it
/// emits.
void add_defaults(Scene& scene, int width, int height);

/// The command line's --eye --at --fov.
struct CameraOverrides {
    std::optional<dvec3> eye, at;
    std::optional<double> fov;
};
Camera override_camera(Camera camera, const CameraOverrides& overrides);

/// The camera after its eye (and up) were turned by `degrees` about the axis `up` through `at`,
/// counter-clockwise seen from above. 0 and 360 give the same camera.
Camera turntable(Camera camera, double degrees);

}  // namespace gw::scene
