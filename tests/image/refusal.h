// What read_texture says of a file that it does not read.
#pragma once

#include "gw/error.h"
#include "image/textures.h"

#include <filesystem>
#include <string>

namespace gw::image {

/// "" where it reads it.
inline std::string refusal(const std::filesystem::path& file) {
    try {
        read_texture(file);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace gw::image
