// Reads a machine's profile from a TOML file. docs/commands.md, "Profiles". Does not know the
// built-in profiles except as `base`.
#pragma once

#include "gw/profile.h"

#include <filesystem>

namespace gw::scene {

/// Keys that the file does not have are as in its `base` (a built-in profile; vgx by default);
/// the name is the file's by default. Throws Error "file:line: what; expected what"; an unknown key
/// names the nearest known one.
Profile read_profile(const std::filesystem::path& path);

}  // namespace gw::scene
