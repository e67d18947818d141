// PNG files through libpng: every command's default format. Internal to image/. Does not know other
// formats (image/formats.h).
#pragma once

#include "image/output/output_file.h"
#include "image/picture.h"
#include "image/texels.h"

#include <filesystem>

namespace gw::image {

/// Whether to write PNG: the extension is .png in upper or lower case.
bool is_png_name(const std::filesystem::path& file);
/// Whether to read PNG, by the first bytes; the name does not matter.
bool holds_png(const std::filesystem::path& file);

/// 8 bits a channel, 16 for a picture of more than 8. Throws an Error that names the target.
void put_png(OutputFile& file, const Picture& picture);

/// Ignores gamma and colour profiles. Throws Error "what; expected what" without the file's name.
Texels read_png(const std::filesystem::path& file);

}  // namespace gw::image
