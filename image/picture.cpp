#include "image/picture.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace gw::image {
namespace {

std::uint16_t mean_of(const Picture& p, int x0, int y0, int factor, int channel) {
    const int x1 = std::min(x0 + factor, p.width), y1 = std::min(y0 + factor, p.height);
    std::uint64_t sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            sum += p.values[pixel_index(x, y, p.width) * std::size_t(p.channels) +
                            std::size_t(channel)];
    const auto count = std::uint64_t(x1 - x0) * std::uint64_t(y1 - y0);
    return static_cast<std::uint16_t>((sum + count / 2) / count);
}

}  // namespace

Picture picture_of(const std::vector<Rgba>& color, int width, int height, int bits) {
    Picture picture{.width = width, .height = height, .channels = 3, .bits = bits, .values = {}};
    picture.values.resize(color.size() * 3);
    std::uint16_t* to = picture.values.data();
    for (const Rgba& pixel : color)
        for (std::size_t c = 0; c < 3; ++c) *to++ = pixel[c];
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

Picture downscaled(const Picture& picture, int factor) {
    Picture small{.width = (picture.width + factor - 1) / factor,
                  .height = (picture.height + factor - 1) / factor,
                  .channels = picture.channels,
                  .bits = picture.bits,
                  .values = {}};
    for (int y = 0; y < picture.height; y += factor)
        for (int x = 0; x < picture.width; x += factor)
            for (int c = 0; c < picture.channels; ++c)
                small.values.push_back(mean_of(picture, x, y, factor, c));
    return small;
}

}  // namespace gw::image
