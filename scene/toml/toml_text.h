// Checks and filters a text before toml++ reads it. toml++ asks whether characters beyond ASCII are
// white space, and for many of them its table has undefined behaviour. Does not parse.
#pragma once

#include <string>

namespace gw::scene {

/// The text with ASCII comments; line numbers stay. Throws Error "file:line: ..." for a character
/// beyond ASCII outside of strings and comments, or at the start of a line after an escaped end of
/// line in a string.
std::string toml_text(const std::string& file, std::string text);

}  // namespace gw::scene
