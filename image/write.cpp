#include "image/write.h"

#include "gw/arithmetic.h"
#include "gw/error.h"
#include "image/encode.h"

namespace gw::image {

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

void check_extension(const std::filesystem::path& file) {
    if (writer_for(file)) return;
    const std::string extension = file.extension().string();
    throw Error(
        file.string(), 0,
        (extension.empty() ? "has no extension" : "no picture format has the extension " + extension) +
            "; expected .png, .exr, .tif, .jpg, .ppm, .tga or another that OpenImageIO writes");
}

void put_picture(OutputFile& file, const Picture& picture) {
    check_extension(file.target());
    const std::string format = writer_for(file.target())->format_name();
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, wanted_type(format, picture.bits));
    spec.attribute("png:compressionLevel", 2);  // a quarter of the time of 6, an eighth larger
    spec.attribute("DateTime", "");             // the same picture is the same file tomorrow
    Converted converted;
    encode(file, spec, [&](OIIO::TypeDesc stored) { return convert(picture, stored, converted); });
}

void write_picture(const std::filesystem::path& file, const Picture& picture) {
    check_extension(file);
    OutputFile output(file);
    put_picture(output, picture);
    output.commit();
}

void put_values(OutputFile& file, const Values& values) {
    const bool integers = values.values.index() == 0;
    const OIIO::TypeDesc type = integers ? OIIO::TypeDesc::UINT32 : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(values.width, values.height, static_cast<int>(values.channels.size()), type);
    spec.channelnames = values.channels;
    spec.attribute("compression", "zip");
    encode(file, spec, [&](OIIO::TypeDesc) {
        return std::visit([&](const auto& v) { return Samples{type, v.data()}; }, values.values);
    });
}

std::string library_version() { return OIIO_VERSION_STRING; }

}  // namespace gw::image
