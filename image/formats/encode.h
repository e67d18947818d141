// The one place that calls OpenImageIO's writers. Does not choose bits or names: pictures.cpp does.
#pragma once

#include "image/formats.h"
#include "image/formats/one_line.h"

#include <OpenImageIO/imageio.h>

#include <functional>
#include <memory>

namespace gw::image::oiio {

/// A writer for the extension of `file`; null where there is none.
std::unique_ptr<OIIO::ImageOutput> writer_for(const std::filesystem::path& file);

/// Bottom row first, as `type` says.
struct Samples {
    OIIO::TypeDesc type;
    const void* first = nullptr;
};

/// Encodes into `file`. `convert` is called with the type the format will store and gives the
/// samples; they must live until encode returns. Throws Error naming the target.
void encode(const Destination& file, const OIIO::ImageSpec& spec,
            const std::function<Samples(OIIO::TypeDesc stored)>& convert);

/// Throws Error: the target cannot be written, and why.
[[noreturn]] void refuse(const Destination& file, const std::string& why);

}  // namespace gw::image::oiio
