// IES files of luminaires: LM-63 of 1986, 1991, 1995 and 2002. Reads type C photometry with TILT=NONE or
// TILT=INCLUDE. Does not read types A and B, other files' tilt, and the size of the luminous opening: the
// light is a point.
#pragma once

#include "scene/photometry.h"
#include "scene/text/warnings.h"

#include <filesystem>

namespace gw::scene {

/// Throws Error "file:line: what; expected what".
Photometry read_ies(const std::filesystem::path& path, Warnings& warnings);

}  // namespace gw::scene
