// The options that a saved view has for the command that draws it: [picture] of its TOML.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace gw::apps {

/// Whether [picture] may have the option of a picture: not threads, which belong to a computer, and
/// no camera, because a view has one of its own.
bool is_saved(const std::string& option);

/// Gives the parsed command the options of its SCENE, unless the command line has them. Options that
/// the command does not have are passed over. Throws Error with the file and line of a wrong word.
void take_saved_options(CLI::App& command);

}  // namespace gw::apps
