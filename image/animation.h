// Several pictures as one animated GIF, which OpenImageIO writes with a palette for each. Does not
// choose pictures or speed.
#pragma once

#include "image/output/output_file.h"
#include "image/picture.h"

#include <vector>

namespace gw::image {

/// `frames`: of one size, 3 channels of 8 bits, at least one. Throws Error naming the target.
void put_animation(OutputFile& file, const std::vector<Picture>& frames, float frames_per_second);

}  // namespace gw::image
