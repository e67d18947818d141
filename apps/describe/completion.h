// Scripts with which bash and zsh complete commands, options, their words and files. Does not run
// anything.
#pragma once

#include "apps/command/cli_fwd.h"

#include <string>

namespace gw::apps {

std::string bash_completion(const CLI::App& root);
std::string zsh_completion(const CLI::App& root);

}  // namespace gw::apps
