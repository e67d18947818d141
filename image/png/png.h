// PNG files through libpng: the format of every command by default. Internal to image/. Does not
// see other formats (image/formats.h).
#pragma once

#include "image/output/output_file.h"
#include "image/picture.h"
#include "image/texels.h"

#include <filesystem>

namespace gw::image {

/// Whether to write PNG: by the extension, in any case.
bool is_png_name(const std::filesystem::path& file);
/// Whether to read PNG: by the first bytes, whatever the name.
bool holds_png(const std::filesystem::path& file);

/// 8 bits a channel, 16 for a picture of more than 8. Throws Error naming the target.
void put_png(OutputFile& file, const Picture& picture);

/// Ignores gamma and colour profiles. Throws Error "what; expected what" without the file's name.
Texels read_png(const std::filesystem::path& file);

}  // namespace gw::image
