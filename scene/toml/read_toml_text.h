// TOML that is in memory already. Does not read files: toml_value.h does.
#pragma once

#include "scene/toml/toml_value.h"

namespace gw::scene {

/// `name` stands for the file in messages. Throws Error where the text is not TOML.
TomlValue read_toml_text(const std::string& text, const std::filesystem::path& name);

}  // namespace gw::scene
