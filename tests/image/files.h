// A folder that goes away with the test, and files read through OpenImageIO itself. Does not use image/.
#pragma once

#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gw::image {

class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "gw-test-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path_)) {
            found.push_back(entry.path().filename().string());
        }
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    std::filesystem::path path_;
};

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
    found.values.resize(found.spec.image_pixels() * static_cast<std::size_t>(found.spec.nchannels));
    EXPECT_TRUE(
        input->read_image(0, 0, 0, found.spec.nchannels, OIIO::BaseTypeFromC<T>::value, found.values.data()));
    return found;
}

}  // namespace gw::image
