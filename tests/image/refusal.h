// The message of read_texture for a file that it refuses.
#pragma once

#include "gw/error.h"
#include "image/textures.h"

#include <filesystem>
#include <string>

namespace gw::image {

/// "" if it reads the file.
inline std::string refusal(const std::filesystem::path& file) {
    try {
        read_texture(file);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace gw::image
