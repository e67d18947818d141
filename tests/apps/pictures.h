// Pictures that gw wrote, read through OpenImageIO itself.
#pragma once

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

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
    Pixels pixels;
    auto input = OIIO::ImageInput::open(file.string());
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input) return pixels;
    const OIIO::ImageSpec& spec = input->spec();
    pixels = {spec.width, spec.height, spec.nchannels, {}};
    pixels.values.resize(std::size_t(spec.width) * std::size_t(spec.height) *
                         std::size_t(spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, pixels.values.data()));
    return pixels;
}

}  // namespace gw::apps
