// Comparison of two machines: planes, passes with counters and digests, read-backs. Does not
// execute anything.
#pragma once

#include "gw/machine.h"

#include <optional>
#include <string>

namespace gw::fuzz {

/// The first value that differs.
struct Difference {
    std::string what;  ///< "plane depth", "pass 2 'shadow', counter written", "read-back 3"
    std::optional<Plane> plane;
    ivec2 pixel{0};  ///< of a plane
    std::string a, b;
};

/// Compares planes in the order depth, stencil, colour, accumulation, the order of the stages.
std::optional<Difference> first_difference(Machine& a, Machine& b);

}  // namespace gw::fuzz
