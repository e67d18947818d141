// Words of the command line as values: those of render/words/option_values.h, and names of pictures. A
// wrong word ends the command with exit code 2.
#pragma once

#include "render/words/option_values.h"

#include <filesystem>

namespace gw::apps {

using render::number_from;
using render::one_of;
using render::point_from;
using render::range_from;
using render::Size;
using render::size_from;
using render::whole_number_from;

/// Checks the name of a picture to write. Throws UsageError if no format has its extension, Error
/// if the file cannot be written.
void check_picture_target(const std::filesystem::path& file);

}  // namespace gw::apps
