#include "gw/escape_controls.h"

#include <algorithm>
#include <cstdint>

namespace gw {
namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0;  ///< bytes; 0: the text does not begin with a character in UTF-8
};

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return std::uint32_t(static_cast<unsigned char>(text[i]));
    };
    if (byte(0) < 0x80) return {byte(0), 1};
    if (byte(0) < 0xc0 || byte(0) > 0xf7) return {};
    const std::size_t length = byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
    if (length > text.size()) return {};
    std::uint32_t code = byte(0) & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (byte(i) >> 6 != 2) return {};
        code = code << 6 | (byte(i) & 0x3f);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_overlong = code < least[length], is_surrogate = code >= 0xd800 && code < 0xe000;
    return is_overlong || is_surrogate || code > 0x10ffff ? Character{} : Character{code, length};
}

bool is_printable(std::uint32_t code) {
    const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0),
               separates_lines = code == 0x2028 || code == 0x2029,
               turns_direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                                 (code >= 0x202a && code <= 0x202e) ||
                                 (code >= 0x2066 && code <= 0x2069);
    return !is_control && !separates_lines && !turns_direction;
}

}  // namespace

std::string escape_controls(std::string_view text, std::string_view kept) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    while (!text.empty()) {
        const Character character = first_character(text);
        const bool as_it_is = character.length > 0 &&
                              (is_printable(character.code) || kept.find(text[0]) != kept.npos);
        const std::size_t taken = std::max<std::size_t>(character.length, 1);
        if (as_it_is)
            result += text.substr(0, taken);
        else
            for (const char c : text.substr(0, taken)) {
                const auto byte = static_cast<unsigned char>(c);
                result += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
            }
        text.remove_prefix(taken);
    }
    return result;
}

}  // namespace gw
