// A folder that goes away with the test, and files read through OpenImageIO itself. Does not use
// image/.
#pragma once

#include "tests/temporary_folder.h"

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gw::image {

using Folder = TemporaryFolder;

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What a file holds, top row first, as it is stored.
template <class T>
struct Stored {
    OIIO::ImageSpec spec;
    std::vector<T> values;
};

template <class T>
Stored<T> stored_in(const std::filesystem::path& file) {
    Stored<T> found;
    auto input = OIIO::ImageInput::open(file.string());
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input) return found;
    found.spec = input->spec();
    found.values.resize(found.spec.image_pixels() * std::size_t(found.spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, found.spec.nchannels, OIIO::BaseTypeFromC<T>::value,
                                  found.values.data()));
    return found;
}

}  // namespace gw::image
