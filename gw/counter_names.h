// The names of the counters, for tables and files. docs/manual.md, "Counters", says what they
// count.
#pragma once

#include "gw/counters.h"

#include <span>

namespace gw {

struct CounterName {
    const char* name;
    std::uint64_t Counters::*count;
};

/// All of them, in the manual's order.
std::span<const CounterName> counter_names();

}  // namespace gw
