// A panel's command as words of the command line, and which figures are asked for. Does not run
// anything.
#pragma once

#include "apps/command/cli_fwd.h"
#include "apps/figures/figure_table.h"

#include <filesystem>

namespace gw::apps {

/// The words after "gw"; "@" at the beginning of one stands for the folder.
std::vector<std::string> words_of(const Panel& panel, const std::filesystem::path& folder);

/// The value of an option among words; null if the option is absent.
const std::string* option_in(const std::vector<std::string>& words, const std::string& name);
/// Gives the option this value; adds the option if it is absent.
void set_option(std::vector<std::string>& words, const std::string& name, const std::string& value);

/// Adds --only NAME, which may be repeated.
void add_only_option(CLI::App& command, std::vector<std::string>& only);
/// The figures of these names, in the table's order; all figures if there are no names.
std::vector<const Figure*> wanted_figures(const std::vector<std::string>& only);

}  // namespace gw::apps
