// The module libgw_formats.so: its functions (image/formats.h), and the one place that calls
// OpenImageIO's writers. Does not choose bits or names: pictures.cpp does.
#pragma once

#include "image/formats.h"
#include "image/formats/one_line.h"

#include <OpenImageIO/imageio.h>

#include <functional>
#include <memory>

namespace gw::image::oiio {

/// A writer for the extension of `file`; null if there is none.
std::unique_ptr<OIIO::ImageOutput> writer_for(const std::filesystem::path& file);

/// Samples of one type, bottom row first.
struct Samples {
    OIIO::TypeDesc type;
    const void* first = nullptr;
};

/// The same values are the same file tomorrow.
void leave_out_time(OIIO::ImageSpec& spec);

/// Encodes into `file`, without the time. `convert` gets the type that the format will store and returns the samples,
/// which must live until encode returns. Throws an Error that names the target.
void encode(const Destination& file, OIIO::ImageSpec spec,
            const std::function<Samples(OIIO::TypeDesc stored)>& convert);

/// Throws Error: the target cannot be written, and why.
[[noreturn]] void refuse(const Destination& file, const std::string& why);

/// Silences stderr while the picture libraries run: libpng and others print errors that OpenImageIO
/// reports too. Redirects the descriptor of the whole process, so other threads' output is lost too.
class SilenceStderr {
public:
    SilenceStderr();
    ~SilenceStderr();
    SilenceStderr(const SilenceStderr&) = delete;
    SilenceStderr& operator=(const SilenceStderr&) = delete;

private:
    int kept_ = -1;
};

// The functions of the module, as in image/formats.h.
std::string format_of(const std::filesystem::path& file);
void put_picture(const Destination& file, const Picture& picture);
void put_values(const Destination& file, const Values& values);
void put_layers(const Destination& file, const Layers& layers);
Layers read_layers(const std::filesystem::path& file, bool with_values);

}  // namespace gw::image::oiio
