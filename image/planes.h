// A machine's planes as pictures, and as files in a folder: NAME.exr with the exact values,
// NAME.png to look at. Does not read them back from a machine.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "image/output/output_set.h"
#include "image/picture.h"

namespace gw::image {

/// A plane to look at: the colours, or false colours (image/false_color.h).
Picture plane_picture(const Planes& planes, Plane plane, const Profile& profile);

/// Distances between the pixels of two planes, bottom row first: black for none, dark grey for the
/// least distance to white for the greatest.
Picture distance_picture(const std::vector<std::uint64_t>& distances, int width, int height);

/// color.exr (fractions), depth.exr, stencil.exr (32-bit integers, channel Z and S), accum.exr
/// (floats, units of the frame buffer, exact up to 2^24), each with a .png in false colours
/// (image/false_color.h).
void put_planes(OutputSet& files, const std::filesystem::path& folder, const Planes& planes,
                const Profile& profile);

/// ids.exr (32-bit integers, channel "id") and ids.png; `none`: nothing is there.
void put_ids(OutputSet& files, const std::filesystem::path& folder,
             const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

}  // namespace gw::image
