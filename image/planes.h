// A machine's planes as files in a folder: NAME.exr with the exact values, NAME.png for the eye
// (plane_pictures.h). Does not read them back from a machine.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "image/output/output_set.h"
#include "image/picture.h"

namespace gw::image {

/// color.exr (fractions), depth.exr, stencil.exr (32-bit integers, channel Z and S), accum.exr
/// (floats, units of the frame buffer, exact up to 2^24), each with a .png in false colours. color.png
/// is `shown`, if it is not null.
void put_planes(OutputSet& files, const std::filesystem::path& folder, const Planes& planes,
                const Profile& profile, const Picture* shown = nullptr);

/// ids.exr (32-bit integers, channel "id") and ids.png. `none` is the identifier of the background.
void put_ids(OutputSet& files, const std::filesystem::path& folder,
             const std::vector<std::uint32_t>& ids, int width, int height, std::uint32_t none);

}  // namespace gw::image
