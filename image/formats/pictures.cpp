#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "image/formats/encode.h"

#include <fstream>
#include <iterator>

namespace gw::image::oiio {
namespace {

OIIO::TypeDesc wanted_type(const std::string& format, int bits) {
    if (format == "openexr") return bits <= 8 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
    return bits <= 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
}

// A picture's values in the three forms that files hold.
struct Converted {
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
};

Samples convert(const Picture& picture, OIIO::TypeDesc stored, Converted& to) {
    if (stored == OIIO::TypeDesc::UINT8) {
        for (std::uint16_t v : picture.values) {
            to.bytes.push_back(static_cast<std::uint8_t>(rescale(v, picture.bits, 8)));
        }
        return {OIIO::TypeDesc::UINT8, to.bytes.data()};
    }
    if (stored.is_floating_point()) {
        const auto max = static_cast<float>((1 << picture.bits) - 1);
        for (std::uint16_t v : picture.values) to.floats.push_back(static_cast<float>(v) / max);
        return {OIIO::TypeDesc::FLOAT, to.floats.data()};
    }
    for (std::uint16_t v : picture.values)
        to.words.push_back(static_cast<std::uint16_t>(rescale(v, picture.bits, 16)));
    return {OIIO::TypeDesc::UINT16, to.words.data()};
}

std::vector<std::uint8_t> top_row_first(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    const auto row = std::size_t(picture.width) * 3;
    for (int y = picture.height - 1; y >= 0; --y)
        for (std::size_t i = 0; i < row; ++i)
            bytes.push_back(static_cast<std::uint8_t>(picture.values[std::size_t(y) * row + i]));
    return bytes;
}

}  // namespace

std::string format_of(const std::filesystem::path& file) {
    const auto writer = writer_for(file);
    return writer ? writer->format_name() : "";
}

void put_picture(const Destination& file, const Picture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                         wanted_type(format_of(file.target), picture.bits));
    spec.attribute("DateTime", "");  // the same picture is the same file tomorrow
    Converted converted;
    encode(file, spec, [&](OIIO::TypeDesc stored) { return convert(picture, stored, converted); });
}

void put_values(const Destination& file, const Values& values) {
    const bool integers = values.values.index() == 0;
    const OIIO::TypeDesc type = integers ? OIIO::TypeDesc::UINT32 : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(values.width, values.height, static_cast<int>(values.channels.size()),
                         type);
    spec.channelnames = values.channels;
    spec.attribute("compression", "zip");
    encode(file, spec, [&](OIIO::TypeDesc) {
        return std::visit([&](const auto& v) { return Samples{type, v.data()}; }, values.values);
    });
}

void put_animation(const Destination& file, const std::vector<Picture>& frames,
                   float frames_per_second) {
    const SilenceStderr silence;
    const auto output = OIIO::ImageOutput::create("x.gif");
    if (!output) refuse(file, OIIO::geterror());
    OIIO::ImageSpec spec(frames.front().width, frames.front().height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("FramesPerSecond", frames_per_second);
    const std::string name = file.temporary.string();
    if (name.empty()) refuse(file, "it is not a regular file; expected one for an animation");
    const std::vector<OIIO::ImageSpec> specs(frames.size(), spec);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool open = i == 0 ? output->open(name, int(specs.size()), specs.data())
                                 : output->open(name, spec, OIIO::ImageOutput::AppendSubimage);
        if (!open) refuse(file, output->geterror());
        if (!output->write_image(OIIO::TypeDesc::UINT8, top_row_first(frames[i]).data()))
            refuse(file, output->geterror());
    }
    if (!output->close()) refuse(file, output->geterror());
    // The writer does not notice a full disk: a whole GIF ends with its trailer.
    std::ifstream written(name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(written), {}};
    if (bytes.empty() || bytes.back() != ';')
        refuse(file, "the disk may be full; the file is cut short");
}

}  // namespace gw::image::oiio
