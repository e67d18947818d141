// Scenes far from 0, as models in map coordinates are: float32 has steps of half a unit at 5,000,000.
// Their coordinates are counted from a point near the scene instead. Does not read files.
#pragma once

#include "scene/scene.h"

namespace gw::scene {

/// Coordinates are far from 0 if the largest is more than this many sides of their box.
inline constexpr double far_ratio = 16;
/// Beyond this many sides, a part of a scene shows that it is rounded to float32.
inline constexpr double very_far_ratio = 4096;

/// A point near the middle of a box that lies far from 0; else 0. Its coordinates are multiples of a
/// power of two.
dvec3 far_origin(const Bounds& box, double ratio = far_ratio);

/// The same for a scene: its vertices, its camera and its lamps.
dvec3 far_origin(const Scene& scene);

/// Counts objects and camera from `origin`. Not lights: they are float32, so the reader does it.
void count_from(Scene& scene, const dvec3& origin);
void count_from(Camera& camera, const dvec3& origin);

}  // namespace gw::scene
