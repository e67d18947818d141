// A machine's planes as pictures, in their colours or in false colours, and the changes of planes.
// Does not read or write files: planes.h writes them.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "image/picture.h"

#include <array>

namespace gw::image {

/// A plane for the eye, in its colours or in false colours.
Picture plane_picture(const Planes& planes, Plane plane, const Profile& profile);

/// Distances between the pixels of two planes, bottom row first: black for none, dark grey for the
/// least distance to white for the greatest.
Picture distance_picture(const std::vector<std::uint64_t>& distances, int width, int height);

/// Amounts in grey: black for 0, white for the largest.
Picture amount_picture(const std::vector<std::uint32_t>& amounts, int width, int height);

/// A picture's change: every channel's distance, times as much as goes without clamping; at least
/// once.
struct Change {
    Picture picture;
    int times = 1;
};
Change change_picture(const Picture& before, const Picture& after);

/// False colours of depths: the nearest red, over yellow, green and cyan to the farthest blue. The
/// largest value of `bits` bits (the background) is black.
Picture depth_colors(const std::vector<std::uint32_t>& depth, int width, int height, int bits);

/// False colours of parts of a whole: 1 and more red, 3/4 yellow, 1/2 green, 1/4 cyan, nearly 0 blue,
/// linear between; 0 is black.
Picture part_colors(const std::vector<double>& parts, int width, int height);

/// False colours of stencil values: 0 is black; 1, 2, 3, ... are red, green, blue, yellow, cyan,
/// magenta, white, then the same darker.
Picture stencil_colors(const std::vector<std::uint8_t>& stencil, int width, int height);

/// A colour for every identifier, distinct up to 24 bits; `none` is black.
Picture id_colors(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

/// R, G, B as fractions of the picture's largest magnitude; sums below 0 are black.
Picture accum_colors(const std::vector<std::array<std::int32_t, 4>>& accum, int width, int height);

}  // namespace gw::image
