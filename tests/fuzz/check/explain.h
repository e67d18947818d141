// The history of a pixel on the reference machine, and the stage that a difference points to. Does
// not find differences.
#pragma once

#include "tests/fuzz/run.h"

#include <string>
#include <string_view>

namespace gw::fuzz {

/// Runs the list up to and including `command` on an observed reference machine. Lines: the stage,
/// then each fragment of the pixel in that command, the test that killed it, its changes.
std::string explain_pixel(const Case& c, std::size_t command, const Difference& difference);

/// The report of a failure of list `index`: the command, the first plane, pixel and values that
/// differ, the stage, and a command line that repeats it. `a` and `b` are the machines' names.
std::string report(const Suite& suite, std::uint64_t index, const Case& c, const Failure& failure,
                   std::string_view a, std::string_view b);

/// Runs lists low .. high - 1 of a suite on the reference and the fast machine. Returns the report
/// of the first failure, or the text of diversity.h; empty if there is neither.
std::string disagreement(const Suite& suite, std::uint64_t low, std::uint64_t high);

}  // namespace gw::fuzz
