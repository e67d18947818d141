// The texture unit at one pixel: coordinates, level, filter. docs/manual/texture.md, "Textures".
// Does not combine the texel with the fragment's colour: texture_environment in gw/stages/tables.h
// does.
#pragma once

#include "gw/reference/interpolants.h"
#include "gw/stages/texels.h"

namespace gw::reference {

/// The texture's value at a pixel that the primitive covers.
Rgba texel_at(const Interpolants& values, const Texels& texels, const Resolved& state,
              int depth_bits, int x, int y);

}  // namespace gw::reference
