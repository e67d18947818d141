// gw new-algorithm: a subcommand of its own. Does not run algorithms.
#pragma once

#include "apps/command/command.h"

namespace gw::apps {

Command add_new_algorithm(CLI::App& app);

}  // namespace gw::apps
