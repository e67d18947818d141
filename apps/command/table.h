// Rows of words as a table. The first column is aligned to the left, the others to the right, with
// two blanks between. A table that is wider than a terminal is cut into parts.
#pragma once

#include <string>
#include <vector>

namespace gw::apps {

/// Each row has as many words as the first. Their control characters are escaped
/// (gw/escape_controls.h): a name cannot add a row.
std::string table(std::vector<std::vector<std::string>> rows);

/// The table in as few parts as lines of `width` characters allow, an empty line between them. Each
/// part repeats the first column and has the same number of further columns, at least one.
std::string table_in_parts(const std::vector<std::vector<std::string>>& rows, std::size_t width);

}  // namespace gw::apps
