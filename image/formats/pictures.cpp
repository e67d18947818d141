#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "image/formats/encode.h"

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

}  // namespace

std::string format_of(const std::filesystem::path& file) {
    const auto writer = writer_for(file);
    return writer ? writer->format_name() : "";
}

void put_picture(const Destination& file, const Picture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                         wanted_type(format_of(file.target), picture.bits));
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
}  // namespace gw::image::oiio
