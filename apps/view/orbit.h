// Motions of a camera by the mouse: around the point it looks at, sideways, nearer. World space.
#pragma once

#include "scene/scene.h"

namespace gw::apps {

/// Turns the eye about `at`: `right` degrees to the right about `up`, `above` degrees upwards. Never
/// closer than a degree to the line along `up`.
scene::Camera orbited(scene::Camera camera, double right, double above);

/// Moves eye and `at` in the picture's plane. A point at the distance of `at` moves by the parts
/// `right` and `up` of the picture's height.
scene::Camera panned(scene::Camera camera, double right, double up);

/// The distance from `at` times `factor`; of an orthographic camera its height.
scene::Camera zoomed(scene::Camera camera, double factor);

}  // namespace gw::apps
