// Base64 of [RFC 4648], strictly. Does not know where the text is from.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gw::scene {

/// The bytes; none if the text has other characters, a wrong length or bits that are left over.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace gw::scene
