// A case as text, for a report: what differs from the initial state, one line a command. Does not
// read it back: the command line repeats it.
#pragma once

#include "tests/fuzz/case.h"

#include <string>

namespace gw::fuzz {

std::string describe(const Case& c);
std::string describe(const Command& command);

}  // namespace gw::fuzz
