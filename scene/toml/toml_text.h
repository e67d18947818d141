// What toml++ may be given to read: it asks characters beyond ASCII whether they are white space,
// and for many of them its table has undefined behaviour instead of an answer. Does not parse.
#pragma once

#include <string>

namespace gw::scene {

/// The text with ASCII comments; lines stay where they are. Throws Error "file:line: ..." where a
/// character beyond ASCII stands outside of strings and comments, where TOML has none, or is the
/// first in a string's line after an escaped end of line.
std::string toml_text(const std::string& file, std::string text);

}  // namespace gw::scene
