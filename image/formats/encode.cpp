#include "image/formats/encode.h"

#include "gw/error.h"

#include <OpenImageIO/filesystem.h>

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <cstdio>

namespace gw::image::oiio {
namespace {

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void write_samples(OIIO::ImageOutput& output, const Destination& file, const std::string& name,
                   const OIIO::ImageSpec& spec,
                   const std::function<Samples(OIIO::TypeDesc stored)>& convert) {
    if (!output.open(name, spec)) refuse(file, output.geterror());
    const Samples samples = convert(output.spec().format);
    const auto row = static_cast<OIIO::stride_t>(samples.type.size()) * spec.nchannels * spec.width;
    const char* top_row = static_cast<const char*>(samples.first) + row * (spec.height - 1);
    if (!output.write_image(samples.type, top_row, OIIO::AutoStride, -row))
        refuse(file, output.geterror());
    if (!output.close()) refuse(file, output.geterror());
}

// For the few formats that only write to named files, and may not notice a full disk.
void check_readable(const Destination& file, const std::string& name, const OIIO::ImageSpec& spec,
                    const char* format) {
    auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec found;
    std::vector<float> row(std::size_t(spec.width) * 4);
    const bool whole =
        input && input->open(name, found) && found.width == spec.width &&
        found.height == spec.height && found.nchannels <= 4 &&
        input->read_scanline(found.y + found.height - 1, 0, OIIO::TypeFloat, row.data());
    if (!whole) refuse(file, "the disk may be full; the written file cannot be read back");
}

}  // namespace

void refuse(const Destination& file, const std::string& why) {
    throw Error(file.target.string(), 0, "cannot be written: " + one_line(why));
}

std::unique_ptr<OIIO::ImageOutput> writer_for(const std::filesystem::path& file) {
    const std::string extension = extension_of(file);
    // These two write no file.
    if (extension.empty() || extension == "null" || extension == "term") return nullptr;
    auto output = OIIO::ImageOutput::create("x." + extension);
    OIIO::geterror();  // or it is printed when the process ends
    return output;
}

void leave_out_time(OIIO::ImageSpec& spec) { spec.attribute("DateTime", ""); }

void encode(const Destination& file, OIIO::ImageSpec spec,
            const std::function<Samples(OIIO::TypeDesc stored)>& convert) {
    leave_out_time(spec);
    const SilenceStderr silence;
    auto output = writer_for(file.target);
    if (!output) refuse(file, "no format of this extension");
    if (output->supports("ioproxy")) {
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOVecOutput memory(bytes);
        output->set_ioproxy(&memory);
        write_samples(*output, file, file.target.string(), spec, convert);
        return file.write(bytes);
    }
    const std::string name = file.temporary.string();
    if (name.empty()) refuse(file, "it is not a regular file; expected one for this format");
    write_samples(*output, file, name, spec, convert);
    check_readable(file, name, spec, output->format_name());
}

SilenceStderr::SilenceStderr() {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    std::fflush(stderr);
    kept_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    if (kept_ >= 0) ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
}

SilenceStderr::~SilenceStderr() {
    if (kept_ < 0) return;
    std::fflush(stderr);
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
}

extern "C" __attribute__((visibility("default"))) const Formats gw_formats{
    .format_of = format_of,
    .put_picture = put_picture,
    .put_values = put_values,
    .put_layers = put_layers,
    .read_layers = read_layers,
};

}  // namespace gw::image::oiio
