// The texels that a plane has as texture: of a slot, or of a surface. docs/manual/pixels.md and
// docs/manual/surfaces.md. Does not filter.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "gw/stages/texels.h"

#include <vector>

namespace gw {

/// Of a rectangle of the plane of colours or depths; `colors` are those of `planes` that are read.
Texels plane_texels(Plane plane, const Rect& rect, const std::vector<Rgba>& colors,
                    const Planes& planes, const Profile& profile);

}  // namespace gw
