// What the lists of a range reached: planes that vary, counters that moved. Does not compare
// machines.
#pragma once

#include "tests/fuzz/case.h"

#include "gw/machine.h"

#include <string>

namespace gw::fuzz {

struct Diversity {
    std::uint64_t lists = 0, commands = 0;
    /// lists at whose end the plane has two values or more
    std::array<std::uint64_t, 4> varied{};
    Counters counters;  ///< of all lists

    void add(const Case& c, Machine& machine);
};

/// What the suite should have reached and did not; empty where all is well. Fewer than 20 lists
/// prove nothing either way.
std::string missing(const Diversity& reached, const Suite& suite);
/// One line.
std::string summary(const Diversity& reached);

}  // namespace gw::fuzz
