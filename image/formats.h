// The calls into OpenImageIO, as one table in the module libgw_formats.so. The first caller loads
// it, since its libraries take a fifth of a second. Internal to image/. PNG does not need it
// (image/png.h).
#pragma once

#include "image/layers.h"
#include "image/picture.h"
#include "image/write.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gw::image {

/// An OutputFile as the module sees it. Formats that only write to named files fill in `temporary`.
struct Destination {
    std::filesystem::path target, temporary;
    std::function<void(std::span<const std::uint8_t>)> write;
};

struct Formats {
    /// The format for files of this extension; "" if there is none.
    std::string (*format_of)(const std::filesystem::path& file);
    void (*put_picture)(const Destination& file, const Picture& picture);
    void (*put_values)(const Destination& file, const Values& values);
    void (*put_layers)(const Destination& file, const Layers& layers);
    Layers (*read_layers)(const std::filesystem::path& file, bool with_values);
};

Destination destination(OutputFile& file);

/// Throws Error with the reason if the module cannot be loaded.
const Formats& formats();

}  // namespace gw::image
