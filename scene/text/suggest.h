// Suggestions for misspelt names: "unknown material 'rde'; the nearest known is 'red'".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gw::scene {

/// The least number of insertions, deletions, replacements and swaps of neighbours that turn `a`
/// into `b`; case counts.
int edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, the first of several; empty if there is none.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

/// "unknown WHAT 'NAME' in WHERE; the nearest known is 'NEAREST'", or "...; none is known". An
/// empty `where` is left out.
std::string unknown(std::string_view what, std::string_view name,
                    const std::vector<std::string>& known, std::string_view where = {});

/// A piece of a file for a message of one line: at most `most` of its bytes, shown.
std::string printable(std::string_view text, std::size_t most = 40);

}  // namespace gw::scene
