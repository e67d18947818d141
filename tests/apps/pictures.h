// Pictures that gw wrote, and a texture that it reads, through OpenImageIO itself (tests/judge).
#pragma once

#include "tests/judge/judge.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <vector>

namespace gw::apps {

/// Values as fractions, top row first.
struct Pixels {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    /// x from the left, y from the top.
    std::vector<float> at(int x, int y) const {
        const auto first = values.begin() + (y * width + x) * channels;
        return {first, first + channels};
    }
};

inline Pixels read_pixels(const std::filesystem::path& file) {
    const auto [spec, values] = judge::stored_in<float>(file);
    return {spec.width, spec.height, spec.channels, values};
}

/// A texture of one texel. PNG needs no OpenImageIO, whose libraries take half a second to load.
inline void write_pixel(const std::filesystem::path& file,
                        const std::array<unsigned char, 3>& color) {
    ASSERT_TRUE(judge::store(file, {1, 1, 3}, std::vector(color.begin(), color.end())));
}

}  // namespace gw::apps
