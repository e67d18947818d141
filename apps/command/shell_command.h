// A command of gw as a line that can be pasted in a shell at the repository's root.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// "build/release/bin/gw render 'my scene.toml'": words that a shell would change are quoted.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace gw::apps
