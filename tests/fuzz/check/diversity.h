// The planes that vary and the counters that move in a range of lists. Does not compare machines.
#pragma once

#include "tests/fuzz/suites.h"

#include "gw/machine.h"

#include <string>

namespace gw::fuzz {

struct Diversity {
    std::uint64_t lists = 0, commands = 0;
    /// lists that leave two values or more in the plane
    std::array<std::uint64_t, every_plane.size()> varied{};
    Counters counters;  ///< of all lists

    void add(const Case& c, Machine& machine);
};

/// The planes and counters that the suite should have reached and did not. Empty for fewer than 20
/// lists, which prove nothing.
std::string missing(const Diversity& reached, const Suite& suite);
/// One line.
std::string summary(const Diversity& reached);

}  // namespace gw::fuzz
