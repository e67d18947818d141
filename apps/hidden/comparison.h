// The data of the page of a comparison (web/compare; web/model/comparison.ts has the types). Does
// not write files.
#pragma once

#include "apps/hidden/files.h"
#include "apps/hidden/lettering.h"

#include <map>
#include <string>
#include <vector>

namespace gw::apps {

/// As JSON. Planes are runs: count, value, count, value ... from the upper left pixel, row by row.
std::string comparison_json(const hiddensurface::Input& input, const std::vector<Compared>& all,
                            const std::map<std::uint32_t, Color>& colors);

}  // namespace gw::apps
