// Pictures that gw wrote, and a texture that it reads, through OpenImageIO itself.
#pragma once

#include <OpenImageIO/imageio.h>

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

/// A texture of one texel. PNG needs no OpenImageIO, whose libraries take half a second to load.
inline void write_pixel(const std::filesystem::path& file,
                        const std::array<unsigned char, 3>& color) {
    auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output) << OIIO::geterror();
    ASSERT_TRUE(output->open(file.string(), {1, 1, 3, OIIO::TypeUInt8})) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUInt8, color.data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

}  // namespace gw::apps
