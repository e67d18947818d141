// What messages call a command. Does not print its contents.
#pragma once

#include "gw/command_list.h"

namespace gw {

/// "Draw", "WritePixels": the name of its type.
const char* command_name(const Command& command);

}  // namespace gw
