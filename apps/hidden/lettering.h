// Text in pictures: letters, digits and signs of ASCII, 5 x 7 dots each, and tails of 2 dots. Needs
// no font file.
#pragma once

#include "image/picture.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gw::apps {

using Color = std::array<std::uint16_t, 3>;

/// Writes one line into a picture of 3 channels of 8 bits. `left` and `top` place the first letter,
/// in pixels from the picture's upper left corner. A dot is scale x scale pixels. Dots outside the
/// picture are left out; a character outside ASCII is a box.
void write_text(image::Picture& picture, int left, int top, int scale, const Color& color,
                std::string_view text);

struct Word {
    std::string text;
    Color color{255, 255, 255};
};
using TextLine = std::vector<Word>;

/// The picture with lines of words above it on dark ground. Dots are as large as the line allows,
/// at most a 160th of the picture's width. So the strip's height depends only on the width and the
/// number of lines.
image::Picture captioned(const image::Picture& picture, const std::vector<TextLine>& lines);

}  // namespace gw::apps
