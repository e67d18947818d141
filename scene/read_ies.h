// IES files of luminaires: LM-63 of 1986, 1991, 1995, 2002 and 2019. Reads photometry of types C and B
// with TILT=NONE or TILT=INCLUDE. Does not read type A, other files' tilt, and the size of the luminous
// opening: the light is a point.
#pragma once

#include "scene/photometry.h"
#include "scene/text/warnings.h"

#include <filesystem>

namespace gw::scene {

/// Throws Error "file:line: what; expected what".
Photometry read_ies(const std::filesystem::path& path, Warnings& warnings);

}  // namespace gw::scene
