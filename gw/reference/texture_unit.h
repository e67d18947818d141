// The texture unit at one pixel: coordinates, level, filter. docs/manual/texture.md, "Textures".
// Does not combine the texel with the fragment's colour: texture_environment in gw/stages/tables.h
// does.
#pragma once

#include "gw/reference/interpolants.h"
#include "gw/reference/observer.h"
#include "gw/stages/texels.h"

#include <optional>

namespace gw::reference {

/// U W 2^e in units of 1/256 texel of a level whose side is 2^log2_size; `uw` is U W.
int level_coordinate(const PerspectiveValue& value, float uw, int log2_size, Wrap wrap);

/// What a unit compares at a pixel; nothing if its texture has no comparison, or q is not positive.
std::optional<DepthComparison> comparison_at(const Interpolants& values, std::size_t unit,
                                             const Texels& texels, const Resolved& state, int x,
                                             int y);

/// The value of a unit's texture at a pixel that the primitive covers.
Rgba texel_at(const Interpolants& values, std::size_t unit, const Texels& texels,
              const Resolved& state, int x, int y);

}  // namespace gw::reference
