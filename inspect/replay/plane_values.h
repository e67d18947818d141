// The pixels at which two sets of planes differ, in window coordinates; `text` functions of
// findings turn them into picture coordinates.
#pragma once

#include "gw/names.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::inspect {

/// In the order in which a fragment reaches them.
inline constexpr std::array<Plane, 5> planes_in_order{Plane::Stencil, Plane::Depth, Plane::Color,
                                                      Plane::Back, Plane::Accum};

/// The sum of the channels' absolute differences at a pixel.
std::uint64_t distance(const Planes& a, const Planes& b, Plane plane, int x, int y);

/// Of all pixels, bottom row first.
std::vector<std::uint64_t> distances(const Planes& a, const Planes& b, Plane plane);

/// Planes of the same size. A plane that one of them lacks is the same.
bool same(const Planes& a, const Planes& b, Plane plane);
/// The pixel that comes first in a picture: from the top row, from the left.
std::optional<ivec2> first_difference(const Planes& a, const Planes& b, Plane plane);

struct WrongPixel {
    int x = 0, y = 0;
    std::uint64_t distance = 0;
};
/// Every pixel that differs, worst first; among equals in the picture's order.
std::vector<WrongPixel> wrong_pixels(const Planes& a, const Planes& b, Plane plane);

}  // namespace gw::inspect
