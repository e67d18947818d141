#include "image/picture.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace gw::image {

Picture picture_of(const std::vector<Rgba>& color, int width, int height, int bits) {
    Picture picture{.width = width, .height = height, .channels = 3, .bits = bits, .values = {}};
    picture.values.reserve(color.size() * 3);
    for (const Rgba& pixel : color) {
        picture.values.insert(picture.values.end(), pixel.begin(), pixel.begin() + 3);
    }
    return picture;
}

Picture toned(Picture picture, const Tone& tone) {
    if (tone == Tone{}) return picture;
    const int max = (1 << picture.bits) - 1;
    const double brighter = gw::pow(2, tone.exposure);
    std::vector<std::uint16_t> table(std::size_t(max) + 1);
    for (int v = 0; v <= max; ++v) {
        const double light = std::min(1.0, v * brighter / max);
        const double shown = gw::pow(light, 1 / tone.gamma);
        table[std::size_t(v)] = static_cast<std::uint16_t>(std::lround(shown * max));
    }
    for (std::uint16_t& value : picture.values) value = table[value];
    return picture;
}

}  // namespace gw::image
