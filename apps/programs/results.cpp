#include "apps/programs/results.h"

#include "gw/error.h"
#include "image/output/temporaries.h"

#include <stdlib.h>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gw::apps {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "gw-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw Error(name + ": cannot be written: " + std::strerror(errno));
    path_ = name;
    image::register_temporary_tree(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    image::forget_temporary(path_);
}

std::string bytes_of_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::uint64_t frames_in(const std::string& statistics) {
    std::uint64_t frames = 0;
    std::from_chars(statistics.data(), statistics.data() + statistics.size(), frames);
    return frames;
}

image::Picture picture_of_ppm(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string kind;
    int width = 0, height = 0, largest = 0;
    in >> kind >> width >> height >> largest;
    in.get();
    if (!in || kind != "P6" || width < 1 || height < 1 || largest < 1 || largest > 65535)
        throw Error("the screenshot is damaged; expected a PPM");
    const int bits = std::bit_width(unsigned(largest));
    const std::size_t row = std::size_t(width) * 3, size = row * std::size_t(height);
    const std::size_t value_bytes = bits > 8 ? 2 : 1, begin = std::size_t(in.tellg());
    if (bytes.size() - begin != size * value_bytes)
        throw Error("the screenshot is damaged; expected all its rows");
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[begin + i]); };
    image::Picture picture{.width = width, .height = height, .bits = bits, .values = {}};
    picture.values.reserve(size);
    for (std::size_t y = std::size_t(height); y-- > 0;)  // pictures have their bottom row first
        for (std::size_t i = y * row; i < (y + 1) * row; ++i)
            picture.values.push_back(
                bits > 8 ? static_cast<std::uint16_t>(byte(2 * i) << 8 | byte(2 * i + 1))
                         : byte(i));
    return picture;
}

}  // namespace gw::apps
