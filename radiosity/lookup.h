// Colours of a pixmap between its texels' middles, as bilinear filters see them.
#pragma once

#include "radiosity/model.h"

#include <algorithm>

namespace gw::radiosity {

/// The texel at (x, y), or the nearest one inside.
inline const dvec3& texel_at(const Pixmap& pixmap, const std::vector<dvec3>& colors, int x, int y) {
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, pixmap.width - 1));
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, pixmap.height - 1));
    return colors[pixmap.first + row * static_cast<std::size_t>(pixmap.width) + column];
}

}  // namespace gw::radiosity
