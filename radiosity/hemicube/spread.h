// What parts of pixels carry, spread over the texels by area [F2.2o].
#pragma once

#include "radiosity/hemicube/footprints.h"

namespace gw::radiosity {

/// The texels of a pixmap.
struct TexelSums {
    double* factors = nullptr;               ///< of the whole model
    std::size_t first = 0;                   ///< of the pixmap
    const std::uint32_t* nearest = nullptr;  ///< null: every texel is an element
};

/// Adds the boxes' values to the texels, box by box, and empties `boxes`. A box that lies beside
/// the facet, as a pixel on its border may, is moved, and where it is larger cut, into the facet's
/// bounds.
void spread(const FacetMap& map, Boxes& boxes, const TexelSums& sums) noexcept;

/// Appends boxes first .. end - 1 of `from`. `to` has room.
void append(const Boxes& from, std::size_t first, std::size_t end, Boxes& to) noexcept;

}  // namespace gw::radiosity
