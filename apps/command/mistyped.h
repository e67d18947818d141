// Unknown words of the command line, and the nearest known ones.
#pragma once

#include "apps/command/cli_fwd.h"

#include <optional>
#include <string>

namespace gw::apps {

/// After parsing with allow_extras: "unknown option --siez of gw render; the nearest known is
/// --size", or none.
std::optional<std::string> mistyped(const CLI::App& app);

}  // namespace gw::apps
