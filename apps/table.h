// Rows of words as a table: the first column to the left, the others to the right, two blanks between.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// All rows are as long as the first.
std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace gw::apps
