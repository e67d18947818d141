// The pixels of a picture file before they become a texture. Internal to image/.
#pragma once

#include "gw/error.h"
#include "gw/texture.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace gw::image {

/// R, G, B, A, bottom row first, with as many bits as the file has.
struct Texels {
    int width = 0, height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> rgba;
    float largest = 1;  ///< of R, G, B in the file; above 1 they are clamped
};

/// Call it before any pixel is read: a header may promise more pixels than fit into memory.
inline void check_sides(std::int64_t width, std::int64_t height) {
    const auto fits = [](std::int64_t side) { return side >= 1 && side <= max_texture_size; };
    if (fits(width) && fits(height)) return;
    throw Error("it has " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels; expected sides of 1 to " + std::to_string(max_texture_size));
}

}  // namespace gw::image
