// A machine's planes as pictures in colours or false colours, and as files in a folder: NAME.exr
// with the exact values, NAME.png for the eye. Does not read them back from a machine.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "image/output/output_set.h"
#include "image/picture.h"

#include <array>

namespace gw::image {

/// A plane for the eye, in its colours or in false colours.
Picture plane_picture(const Planes& planes, Plane plane, const Profile& profile);

/// Distances between the pixels of two planes, bottom row first: black for none, dark grey for the
/// least distance to white for the greatest.
Picture distance_picture(const std::vector<std::uint64_t>& distances, int width, int height);

/// color.exr (fractions), depth.exr, stencil.exr (32-bit integers, channel Z and S), accum.exr
/// (floats, units of the frame buffer, exact up to 2^24), each with a .png in false colours.
void put_planes(OutputSet& files, const std::filesystem::path& folder, const Planes& planes,
                const Profile& profile);

/// ids.exr (32-bit integers, channel "id") and ids.png. `none` is the identifier of the background.
void put_ids(OutputSet& files, const std::filesystem::path& folder,
             const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

/// False colours of depths: the nearest red, over yellow, green and cyan to the farthest blue. The
/// largest value of `bits` bits (the background) is black.
Picture depth_colors(const std::vector<std::uint32_t>& depth, int width, int height, int bits);

/// False colours of stencil values: 0 is black; 1, 2, 3, ... are red, green, blue, yellow, cyan,
/// magenta, white, then the same darker.
Picture stencil_colors(const std::vector<std::uint8_t>& stencil, int width, int height);

/// A colour for every identifier, distinct up to 24 bits; `none` is black.
Picture id_colors(const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

/// R, G, B as fractions of the picture's largest magnitude; sums below 0 are black.
Picture accum_colors(const std::vector<std::array<std::int32_t, 4>>& accum, int width, int height);

}  // namespace gw::image
