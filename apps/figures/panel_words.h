// A panel's command as words of the command line, and which figures are asked for. Does not run
// anything.
#pragma once

#include "apps/command/cli_fwd.h"
#include "apps/figures/figure_table.h"

#include <filesystem>

namespace gw::apps {

/// The words after "gw"; those that begin with "@" are in the folder.
std::vector<std::string> words_of(const Panel& panel, const std::filesystem::path& folder);

/// The value of an option among words; null where it is not there.
const std::string* option_in(const std::vector<std::string>& words, const std::string& name);
/// Gives it this value; adds it where it is not there.
void set_option(std::vector<std::string>& words, const std::string& name, const std::string& value);

/// Adds --only NAME, which may be repeated.
void add_only_option(CLI::App& command, std::vector<std::string>& only);
/// Those of these names in the table's order; all where there are none.
std::vector<const Figure*> wanted_figures(const std::vector<std::string>& only);

}  // namespace gw::apps
