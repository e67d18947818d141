// Draws: a mesh with materials, lights and textures. Does not set state: suites do.
#pragma once

#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"

namespace gw::conformance {

Material any_material(Random& random);
/// At most `most` lights around the eye distances 0 .. depth.
LightsRef any_lights(Random& random, int most, double depth);
/// Sides of 1 to 64, mostly powers of two; seldom longer.
TextureRef any_texture(Random& random);
/// A texture, or one of the script's slots; shadow_compare only with depth slots.
TextureBinding any_binding(Script& script);

/// A draw of the mesh, which is not added.
Draw any_draw(Script& script, MeshRef mesh, int mapped_percent = 0);
/// Adds a draw of the mesh in the script's frame and state. It has a material and lights if the
/// colour source is Lighting, and a texture in `mapped_percent` of 100 cases.
void draw(Script& script, MeshRef mesh, int mapped_percent = 0);

/// The largest eye distance of the script's vertices, for fog and lights.
double eye_depth(const Frame& frame);

}  // namespace gw::conformance
