// What indices and lights need of OpenGL beside vertices: a texture of all indices, so that shaded
// indices are rounded at each pixel; lighting of indices; material that changes between vertices.
#pragma once

#include "irisgl/draw/primitives.h"

#include <vector>

namespace gw::irisgl {

/// A texture whose texel i is the pixel of index i. False, with a warning: the profile has no
/// textures of 4096 texels, so indices are not shaded.
bool bind_index_texture();
void use_index_texture(bool on);
/// Gives lit vertices the index of their light.
void light_indices(std::vector<Vertex>& vertices);
/// In a lit primitive: the material of a vertex that is lit, or one that shines in `rgb` only.
void emit_material(bool is_lit, const vec4& rgb);

}  // namespace gw::irisgl
