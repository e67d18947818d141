// Files as one archive for learning platforms. The same files give the same bytes: no times, nothing
// packed.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

/// A ZIP archive [APPNOTE 4.3] of files by name, stored. Names are ASCII; less than 4 GiB together.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace gw::apps
