// Text from anybody's file as one line. A terminal would obey control characters; here they are
// shown, so that a name cannot hide a line or add one.
#pragma once

#include <string>
#include <string_view>

namespace gw {

/// Writes as \\x1b: control characters except those of `kept`, Unicode's line separators, marks that
/// turn the direction of writing, and bytes that are not UTF-8. Shown text stays as it is.
std::string escape_controls(std::string_view text, std::string_view kept = {});

}  // namespace gw
