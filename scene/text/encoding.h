// Texts as UTF-8. Files from Japan may be in Shift-JIS, where the last byte of a character may be a
// '\\'. Does not guess among other encodings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gw::scene {

/// The line, from 1, of the first byte that is not UTF-8; none: the text is UTF-8.
std::optional<int> line_beyond_utf8(std::string_view text);

/// The text of a file of statements in UTF-8. A text that is not UTF-8 is read as Shift-JIS (CP932)
/// if all of its lines are; comment lines do not count, and lose the bytes that fit neither. What
/// DOS put behind a text, ^Z and zeros, is left out. Throws Error "file:line: ..." for a text that
/// is neither.
std::string utf8_of_statements(const std::string& file, std::string text);

/// A name in Shift-JIS (CP932), as archives unpacked from Windows write it on the disk; none: it
/// has characters that Shift-JIS lacks, or only ASCII.
std::optional<std::string> shift_jis_name(std::string_view utf8);

}  // namespace gw::scene
