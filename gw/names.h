// The names of commands, planes and counters, and values as text, for messages, tables and files.
// docs/manual/counters.md defines the counters. Does not print whole commands.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "gw/planes.h"

#include <span>
#include <string>

namespace gw {

/// The name of the command's type: "Draw", "WritePixels".
const char* name_of(const Command& command);

/// "color", "depth", "stencil", "accum", "back"
const char* name_of(Plane plane);

/// The plane's value at one pixel of the window: "12 34 56 255" or "16777215".
std::string value_at(const Planes& planes, Plane plane, int x, int y);

struct CounterName {
    const char* name;
    std::uint64_t Counters::*count;
};

/// All counters, in the manual's order.
std::span<const CounterName> counter_names();

}  // namespace gw
