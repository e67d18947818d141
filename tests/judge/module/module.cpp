#include "tests/judge/judge.h"

#include <OpenImageIO/imageio.h>

namespace gw::judge {
namespace {

OIIO::TypeDesc type_of(Sample sample) {
    switch (sample) {
        case Sample::U8: return OIIO::TypeDesc::UINT8;
        case Sample::U16: return OIIO::TypeDesc::UINT16;
        case Sample::U32: return OIIO::TypeDesc::UINT32;
        case Sample::Half: return OIIO::TypeDesc::HALF;
        case Sample::Float: return OIIO::TypeDesc::FLOAT;
        case Sample::Other: break;
    }
    return {};
}

Sample kind_of(OIIO::TypeDesc type) {
    for (const Sample sample : {Sample::U8, Sample::U16, Sample::U32, Sample::Half, Sample::Float})
        if (type_of(sample) == type) return sample;
    return Sample::Other;
}

std::string read(const std::string& file, Sample as, Spec& spec, std::vector<std::byte>& values) {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file, &hints);
    if (!input) return OIIO::geterror();
    const OIIO::ImageSpec& found = input->spec();
    spec = {found.width, found.height, found.nchannels, kind_of(found.format)};
    values.resize(spec.samples() * type_of(as).size());
    if (!input->read_image(0, 0, 0, found.nchannels, type_of(as), values.data()))
        return input->geterror();
    return "";
}

std::string write(const std::string& file, const Spec& spec, Sample given, const void* values) {
    const auto output = OIIO::ImageOutput::create(file);
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec asked(spec.width, spec.height, spec.channels, type_of(spec.format));
    asked.attribute("oiio:UnassociatedAlpha", 1);
    const bool done =
        output->open(file, asked) && output->write_image(type_of(given), values) && output->close();
    return done ? "" : "not written: " + output->geterror();
}

}  // namespace
}  // namespace gw::judge

extern "C" const gw::judge::Functions gw_judge{gw::judge::read, gw::judge::write};
