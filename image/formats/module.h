// The functions of the module, as in image/formats.h; documented in image/.
#pragma once

#include "image/formats.h"

namespace gw::image::oiio {

std::string format_of(const std::filesystem::path& file);
void put_picture(const Destination& file, const Picture& picture);
void put_values(const Destination& file, const Values& values);
void put_animation(const Destination& file, const std::vector<Picture>& frames,
                   float frames_per_second);
void put_layers(const Destination& file, const Layers& layers);
Layers read_layers(const std::filesystem::path& file, bool with_values);

}  // namespace gw::image::oiio
