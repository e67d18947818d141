// The options that a saved view has for the command that draws it: [picture] of its TOML.
#pragma once

namespace CLI {
class App;
}

namespace gw::apps {

/// Gives the parsed command the options of its SCENE, unless the command line has them. Options that
/// the command does not have are passed over. Throws Error with the file and line of a wrong word.
void take_saved_options(CLI::App& command);

}  // namespace gw::apps
