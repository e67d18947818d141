// Faces of two objects in one plane that look the same way: a lamp flush with the ceiling. Which of
// them a picture shows depends on rounding, so the user is told. Does not change the scene.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace gw::scene {

/// Two objects of different materials whose faces share a part of a plane and look the same way, the
/// first such pair. At least one of them has few faces (most_faces_of_small): lamps, panels, decals.
std::optional<std::pair<std::size_t, std::size_t>> coincident_objects(const Scene& scene);

inline constexpr std::size_t most_faces_of_small = 1024;

}  // namespace gw::scene
