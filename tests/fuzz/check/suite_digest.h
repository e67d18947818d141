// One digest over many lists, which another compiler or processor must reproduce. Does not compare.
#pragma once

#include "tests/fuzz/run.h"

namespace gw::fuzz {

/// Over every plane and counter at the end of lists `low` .. `high` - 1: 16 hexadecimal digits.
std::string suite_digest(const Suite& suite, std::uint64_t low, std::uint64_t high,
                         const MachineMaker& make);
std::string counters_digest(const Counters& counters);

}  // namespace gw::fuzz
