// PNG files through libpng: what every command writes unless told otherwise. Internal to image/.
// Does not see other formats (image/formats.h).
#pragma once

#include "image/output/output_file.h"
#include "image/picture.h"
#include "image/texels.h"

#include <filesystem>

namespace gw::image {

/// By its extension, in any case: to be written as PNG.
bool is_png_name(const std::filesystem::path& file);
/// By its first bytes, whatever its name: to be read as PNG.
bool holds_png(const std::filesystem::path& file);

/// 8 bits a channel, 16 for a picture of more than 8. Throws Error naming the target.
void put_png(OutputFile& file, const Picture& picture);

/// Gamma and colour profiles are not looked at. Throws Error "what; expected what" without the
/// file's name.
Texels read_png(const std::filesystem::path& file);

}  // namespace gw::image
