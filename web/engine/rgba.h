// A picture as JavaScript draws it: R, G, B, A of 8 bits, top row first.
#pragma once

#include "gw/base/arithmetic.h"
#include "image/picture.h"

namespace gw::lab {

inline std::vector<std::uint8_t> rgba_of(const image::Picture& picture) {
    const auto width = std::size_t(picture.width), height = std::size_t(picture.height);
    const auto channels = std::size_t(picture.channels);
    std::vector<std::uint8_t> rgba(width * height * 4, 255);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t from = ((height - 1 - y) * width + x) * channels;
                rgba[(y * width + x) * 4 + c] =
                    std::uint8_t(rescale(picture.values[from + c % channels], picture.bits, 8));
            }
    return rgba;
}

}  // namespace gw::lab
