#include "gw/error.h"
#include "image/formats/encode.h"
#include "image/formats/module.h"
#include "image/formats/silence_stderr.h"

#include <fstream>
#include <iterator>

namespace gw::image::oiio {
namespace {

std::vector<std::uint8_t> top_row_first(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    const auto row = std::size_t(picture.width) * 3;
    for (int y = picture.height - 1; y >= 0; --y)
        for (std::size_t i = 0; i < row; ++i)
            bytes.push_back(static_cast<std::uint8_t>(picture.values[std::size_t(y) * row + i]));
    return bytes;
}

}  // namespace

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
