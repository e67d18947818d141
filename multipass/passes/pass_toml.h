// Pass lists as user data: [[pass]] in a scene's TOML, in the words that passes are printed in.
// docs/passes.md, "A list of one's own", has every key. Does not print for people (pass.h does).
#pragma once

#include "multipass/passes/pass.h"
#include "scene/toml/toml_value.h"

#include <string>
#include <vector>

namespace gw::multipass {

/// The list that the tables say. Throws Error with file and line for what is not a pass, and for a
/// list that cannot draw a picture.
PassList read_passes(const std::vector<scene::TomlValue>& tables);

/// The list as [[pass]] tables; read again they are the same list.
std::string to_toml(const PassList& passes);

}  // namespace gw::multipass
