// Checks and filters a text before toml++ reads it. toml++ asks whether characters beyond ASCII are
// white space, and for many of them its table has undefined behaviour. Does not parse.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gw::scene {

inline bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Tables, arrays and parts of dotted keys in each other. toml++ recurses for each level.
inline constexpr int most_toml_levels = 64;

/// The text with ASCII comments; line numbers stay. Throws Error "file:line: ..." for bytes that are
/// not UTF-8, a number that begins or ends with its point, and more than most_toml_levels. So it does
/// for a character beyond ASCII outside of strings and comments, or, in a string, at the start of a
/// line after an escaped end of line. Appends to `headers` the beginnings of the lines
/// that hold a header, [a.b] or [[a.b]].
std::string toml_text(const std::string& file, std::string text,
                      std::vector<std::size_t>* headers = nullptr);

}  // namespace gw::scene
