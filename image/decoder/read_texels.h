// Reads a picture file's pixels through OpenImageIO.
#pragma once

#include "image/texels.h"

#include <filesystem>

namespace gw::image {

/// Throws Error "what; expected what" without the file's name.
Texels read_texels(const std::filesystem::path& file);

}  // namespace gw::image
