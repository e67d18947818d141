// Objects whose matrix mirrors. A mirrored face shows its other winding to the eye, so its corners are
// taken in reverse: then its front stays its front, for lighting, culling, radiosity and rays
// [GLTF2 3.7.4].
#pragma once

#include "scene/scene.h"

namespace gw::scene {

bool is_mirrored(const dmat4& world_from_object);

/// The faces in reverse; each keeps its first corner. Lines and points as they are.
MeshData reversed(const Mesh& mesh);

/// Once for each scene: gives all mirrored objects reversed meshes, which they share as before.
void reverse_mirrored(Scene& scene);

}  // namespace gw::scene
