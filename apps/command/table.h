// Rows of words as a table: the first column to the left, the others to the right, two blanks
// between; cut into parts where it is wider than a terminal.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// All rows are as long as the first.
std::string table(const std::vector<std::vector<std::string>>& rows);

/// The same in parts below each other, each with the first column and as many of the others as each
/// has: as few parts as lines of `width` characters allow, one column at least in each; an empty
/// line between.
std::string table_in_parts(const std::vector<std::vector<std::string>>& rows, std::size_t width);

}  // namespace gw::apps
