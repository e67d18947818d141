#include "image/downscale.h"

#include <algorithm>

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

Picture reduced(const Picture& picture, int factor) {
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
