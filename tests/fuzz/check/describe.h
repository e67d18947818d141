// A case as text for a report: a line for each command, state as its difference from State{}. The
// text is not read back; a command line repeats the case.
#pragma once

#include "tests/fuzz/suites.h"

#include <string>

namespace gw::fuzz {

std::string describe(const Case& c);
std::string describe(const Command& command);

}  // namespace gw::fuzz
