// A command of gw as a line that can be pasted in a shell at the repository's root.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// "build/release/bin/gw render 'my scene.toml'": words that a shell would change are quoted.
std::string shell_command(const std::vector<std::string>& words);

/// The words of such a line, the program first: what shell_command quoted, unquoted.
std::vector<std::string> shell_words(const std::string& command);

}  // namespace gw::apps
