// Why a pixel is what it is: the reference machine's fragments there, and the stage that a difference points
// to. Does not find differences.
#pragma once

#include "tests/fuzz/run.h"

#include <string>

namespace gw::fuzz {

/// Re-runs the list up to and including `command` on an observed reference machine. Lines: the stage, then
/// each fragment of the pixel in that command, why it died, what it changed.
std::string explain_pixel(const Case& c, std::size_t command, const Difference& difference);

}  // namespace gw::fuzz
