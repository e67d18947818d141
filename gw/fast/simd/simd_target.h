// Selects the Highway target that runs: the best one, or one that a test asks for.
#pragma once

#include <string>
#include <vector>

namespace gw::fast {

/// The vector instruction set in use, by Highway's name, and all sets that this processor has.
std::string simd_target();
std::vector<std::string> simd_targets();
/// Uses only the named target from now on (tests); "" goes back to the best. False if there is no
/// such target.
bool use_simd_target(const std::string& name);

}  // namespace gw::fast
