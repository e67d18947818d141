#include "image/decoder/read_texels.h"

#include "gw/error.h"
#include "image/formats/one_line.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace gw::image {
namespace {

using oiio::one_line;

[[noreturn]] void refuse(const std::string& why, const std::string& expected) {
    throw Error(why + "; expected " + expected);
}

void check_spec(const OIIO::ImageSpec& spec) {
    check_sides(spec.width, spec.height);
    if (spec.deep || spec.depth > 1) refuse("it is a deep or volume picture", "a flat one");
    if (spec.nchannels == 2 && spec.alpha_channel != 1)
        refuse("it has 2 channels", "grey, grey and alpha, RGB or RGBA");
}

std::unique_ptr<OIIO::ImageInput> open(const std::filesystem::path& file) {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    const std::string name = file.string();
    std::unique_ptr<OIIO::ImageInput> input;
    if (name.find('?') == name.npos) {
        input = OIIO::ImageInput::open(name, &hints);
    } else if (file.has_extension()) {
        // In a name that it takes apart, OpenImageIO reads "?" as the begin of options.
        auto by_format = OIIO::ImageInput::create(file.extension().string().substr(1));
        OIIO::ImageSpec found;
        if (by_format && by_format->open(name, found, hints)) input = std::move(by_format);
    }
    if (!input) refuse("it cannot be read: " + one_line(OIIO::geterror()), "a picture file");
    return input;
}

// Some readers fill missing parts with grey and report success with a message. But cameras write
// odd bytes that do no harm.
bool harmless(const std::string& error) {
    return error.find("extraneous bytes before marker") != error.npos;
}

// Bottom row first, `channels` a pixel.
template <class T>
std::vector<T> read_rows(OIIO::ImageInput& input, OIIO::TypeDesc type, int channels) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto row = std::size_t(spec.width) * std::size_t(channels);
    std::vector<T> values(row * std::size_t(spec.height));
    T* top_row = values.data() + row * std::size_t(spec.height - 1);
    const auto row_bytes = static_cast<OIIO::stride_t>(row * sizeof(T));
    input.geterror();  // messages about the header
    const bool read =
        input.read_image(0, 0, 0, channels, type, top_row, OIIO::AutoStride, -row_bytes);
    const std::string error = input.geterror();
    if (!read || !(error.empty() || harmless(error))) {
        refuse("it cannot be read to its end: " + one_line(error), "a whole picture file");
    }
    return values;
}

template <class T>
std::vector<T> spread_to_rgba(const std::vector<T>& values, int channels, T opaque) {
    std::vector<T> rgba;
    rgba.reserve(values.size() / std::size_t(channels) * 4);
    for (std::size_t i = 0; i < values.size(); i += std::size_t(channels)) {
        const T* v = &values[i];
        const bool grey = channels < 3;
        const bool alpha = channels == 2 || channels == 4;
        rgba.insert(rgba.end(), {v[0], grey ? v[0] : v[1], grey ? v[0] : v[2],
                                 alpha ? v[channels - 1] : opaque});
    }
    return rgba;
}

std::uint16_t word_from(float value) {
    const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;  // not a number: 0
    return static_cast<std::uint16_t>(static_cast<double>(clamped) * 65535 + 0.5);
}

/// At least 1; of the channels that are no alpha.
float largest_color(const std::vector<float>& values, int channels) {
    const std::size_t each = std::size_t(channels), colors = channels < 3 ? 1 : 3;
    float largest = 1;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % each < colors && values[i] > largest) largest = values[i];
    return largest;
}

/// OpenImageIO divides by the largest value of a PGM or PPM file without looking at it.
void check_largest_value(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string kind, word;
    in >> kind;
    if (kind != "P2" && kind != "P3" && kind != "P5" && kind != "P6") return;
    for (int numbers = 0; numbers < 3 && in >> word;) {
        if (word[0] == '#')
            std::getline(in, word);
        else
            ++numbers;
    }
    if (word.find_first_not_of('0') == word.npos)
        refuse("its largest value is 0", "one from 1 to 65535");
}

}  // namespace

Texels read_texels(const std::filesystem::path& file) {
    check_largest_value(file);
    const auto input = open(file);
    const OIIO::ImageSpec& spec = input->spec();
    check_spec(spec);
    const int channels = std::min(spec.nchannels, 4);

    if (spec.format == OIIO::TypeDesc::UINT8) {
        const auto values = read_rows<std::uint8_t>(*input, OIIO::TypeDesc::UINT8, channels);
        return {spec.width, spec.height, spread_to_rgba<std::uint8_t>(values, channels, 255)};
    }
    if (spec.format == OIIO::TypeDesc::UINT16) {
        const auto values = read_rows<std::uint16_t>(*input, OIIO::TypeDesc::UINT16, channels);
        return {spec.width, spec.height, spread_to_rgba<std::uint16_t>(values, channels, 65535)};
    }
    const auto floats = read_rows<float>(*input, OIIO::TypeDesc::FLOAT, channels);
    std::vector<std::uint16_t> values(floats.size());
    std::transform(floats.begin(), floats.end(), values.begin(), word_from);
    return {spec.width, spec.height, spread_to_rgba<std::uint16_t>(values, channels, 65535),
            largest_color(floats, channels)};
}

}  // namespace gw::image
