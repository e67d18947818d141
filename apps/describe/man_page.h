// gw(1): what --help says of every command, as a man page.
#pragma once

#include "apps/command/cli_fwd.h"

#include <string>

namespace gw::apps {

std::string man_page(const CLI::App& root);

}  // namespace gw::apps
