// Why a pixel is what it is: the reference machine's fragments there, and the stage that a
// difference points to. Does not find differences.
#pragma once

#include "tests/fuzz/run.h"

#include <string>
#include <string_view>

namespace gw::fuzz {

/// Re-runs the list up to and including `command` on an observed reference machine. Lines: the
/// stage, then each fragment of the pixel in that command, why it died, what it changed.
std::string explain_pixel(const Case& c, std::size_t command, const Difference& difference);

/// All about a failure of list `index`: after which command, the first differing plane, pixel and
/// values, the stage, and one command that repeats it. `a` and `b` are the machines' names.
std::string report(const Suite& suite, std::uint64_t index, const Case& c, const Failure& failure,
                   std::string_view a, std::string_view b);

/// Runs lists low .. high - 1 of a suite on the reference and the fast machine: the first report,
/// or what the lists should have reached and did not; empty where all is well.
std::string disagreement(const Suite& suite, std::uint64_t low, std::uint64_t high);

}  // namespace gw::fuzz
