// A machine's profile from a TOML file. docs/commands.md, "Profiles".
// Does not know the built-in profiles but for `base`.
#pragma once

#include "gw/profile.h"

#include <filesystem>

namespace gw::scene {

/// What the file does not say is as in its `base` (vgx, reality or ideal; vgx where absent). The
/// name is the file's where absent. Throws Error "file:line: what; expected what"; an unknown key
/// names the nearest known one.
Profile read_profile(const std::filesystem::path& path);

}  // namespace gw::scene
