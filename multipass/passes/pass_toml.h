// Pass lists as user data: [[pass]] in a scene's TOML, in the tokens that passes are printed in.
// docs/passes.md, "A list of one's own", has every key. Does not print for people (pass.h).
#pragma once

#include "multipass/passes/pass.h"
#include "scene/toml/toml_value.h"

#include <string>
#include <vector>

namespace gw::multipass {

/// Reads the list. Throws Error with file and line for a table that is no pass, and for a list that
/// cannot draw a picture.
PassList read_passes(const std::vector<scene::TomlValue>& tables);

/// The list as [[pass]] tables. Reading them gives the same list.
std::string to_toml(const PassList& passes);

}  // namespace gw::multipass
