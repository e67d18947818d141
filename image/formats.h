// What OpenImageIO does for this folder, behind one table: it is the module libgw_formats.so, which
// who asks first loads, since the libraries below it take a fifth of a second. Internal to image/.
// PNG does without (image/png/png.h).
#pragma once

#include "image/layers.h"
#include "image/picture.h"
#include "image/texels.h"
#include "image/write.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gw::image {

/// An OutputFile as the module sees it: formats that write to named files only fill in `temporary`.
struct Destination {
    std::filesystem::path target, temporary;
    std::function<void(std::span<const std::uint8_t>)> write;
};

struct Formats {
    /// The name of the format that a file of this extension is written in; "" where there is none.
    std::string (*format_of)(const std::filesystem::path& file);
    void (*put_picture)(const Destination& file, const Picture& picture);
    void (*put_values)(const Destination& file, const Values& values);
    void (*put_animation)(const Destination& file, const std::vector<Picture>& frames,
                          float frames_per_second);
    void (*put_layers)(const Destination& file, const Layers& layers);
    Layers (*read_layers)(const std::filesystem::path& file, bool with_values);
    Texels (*read_texels)(const std::filesystem::path& file);
};

Destination destination(OutputFile& file);

/// Throws Error saying why where the module cannot be loaded.
const Formats& formats();

}  // namespace gw::image
