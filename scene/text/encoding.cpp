#include "scene/text/encoding.h"

#include "gw/error.h"

#include <iconv.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace gw::scene {
namespace {

bool is_ascii(std::string_view text) {
    constexpr std::size_t step = sizeof(std::uint64_t);
    for (; text.size() >= step; text.remove_prefix(step)) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data(), step);
        if (word & 0x8080808080808080u) return false;
    }
    return std::ranges::none_of(text, [](char c) { return static_cast<signed char>(c) < 0; });
}

/// The C library's conversion from one encoding to another.
class Conversion {
public:
    Conversion(const char* to, const char* from) : iconv_(::iconv_open(to, from)) {}
    ~Conversion() {
        if (usable()) ::iconv_close(iconv_);
    }
    Conversion(const Conversion&) = delete;
    Conversion& operator=(const Conversion&) = delete;

    /// None if the text is not in the first encoding, or the second one lacks a character.
    std::optional<std::string> of(std::string_view text) const {
        if (!usable()) return std::nullopt;
        std::string from(text), to(4 * text.size() + 4, '\0');
        char *in = from.data(), *out = to.data();
        std::size_t left = from.size(), room = to.size();
        ::iconv(iconv_, nullptr, nullptr, nullptr, nullptr);
        if (::iconv(iconv_, &in, &left, &out, &room) != 0) return std::nullopt;
        to.resize(to.size() - room);
        return to;
    }

private:
    bool usable() const { return iconv_ != reinterpret_cast<iconv_t>(-1); }
    iconv_t iconv_;
};

/// The bytes of the character that begins at `c`, and the range of the second; 0: none begins so.
struct Sequence {
    std::size_t length = 0;
    unsigned char low = 0x80, high = 0xbf;
};
Sequence sequence_of(unsigned char c) {
    const auto first = [](bool is, unsigned char yes, unsigned char no) { return is ? yes : no; };
    if (c < 0x80) return {1};
    if (c < 0xc2 || c > 0xf4) return {};
    if (c < 0xe0) return {2};
    if (c < 0xf0) return {3, first(c == 0xe0, 0xa0, 0x80), first(c == 0xed, 0x9f, 0xbf)};
    return {4, first(c == 0xf0, 0x90, 0x80), first(c == 0xf4, 0x8f, 0xbf)};
}

bool is_utf8(std::string_view text) {
    if (is_ascii(text)) return true;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (std::size_t at = 0, next = 0; at < text.size(); at = next) {
        const Sequence sequence = sequence_of(byte(at));
        next = at + sequence.length;
        if (sequence.length == 0 || next > text.size()) return false;
        if (next > at + 1 && (byte(at + 1) < sequence.low || byte(at + 1) > sequence.high))
            return false;
        for (std::size_t i = at + 2; i < next; ++i)
            if (byte(i) >> 6 != 2) return false;
    }
    return true;
}

/// Takes the next line off the text, with its end.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view line = text.substr(0, end + 1);
    text.remove_prefix(line.size());
    return line;
}

bool is_comment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t\r\v\f");
    return first != line.npos && line[first] == '#';
}

std::string without_high_bytes(std::string_view line) {
    std::string plain(line);
    std::ranges::replace_if(
        plain, [](char c) { return static_cast<signed char>(c) < 0; }, '?');
    return plain;
}

/// The text line by line in UTF-8; a comment that has none as it is. Else `fault` is the line.
template <class Convert>
std::optional<std::string> converted(std::string_view text, const Convert& convert, int& fault) {
    std::string result;
    result.reserve(text.size());
    for (fault = 1; !text.empty(); ++fault) {
        const std::string_view line = take_line(text);
        const std::optional<std::string> good = convert(line);
        if (!good && !is_comment(line)) return std::nullopt;
        result += good ? *good : without_high_bytes(line);
    }
    return result;
}

}  // namespace

std::optional<int> line_beyond_utf8(std::string_view text) {
    if (is_ascii(text)) return std::nullopt;
    for (int line = 1; !text.empty(); ++line)
        if (!is_utf8(take_line(text))) return line;
    return std::nullopt;
}

std::string utf8_of_statements(const std::string& file, std::string text) {
    constexpr std::string_view marks_of_end("\x1a\0", 2);
    text.resize(text.find_last_not_of(marks_of_end) + 1);
    if (is_utf8(text)) return text;
    const auto as_it_is = [](std::string_view line) {
        return is_utf8(line) ? std::optional<std::string>(line) : std::nullopt;
    };
    const Conversion shift_jis("UTF-8", "CP932");
    const auto from_shift_jis = [&](std::string_view line) {
        return is_ascii(line) ? std::optional<std::string>(line) : shift_jis.of(line);
    };
    int line = 0;
    if (auto utf8 = converted(text, as_it_is, line)) return std::move(*utf8);
    if (auto utf8 = converted(text, from_shift_jis, line)) return std::move(*utf8);
    throw Error(file, line, "is neither UTF-8 nor Shift-JIS; expected UTF-8 text");
}

std::optional<std::string> shift_jis_name(std::string_view utf8) {
    if (is_ascii(utf8)) return std::nullopt;
    return Conversion("CP932", "UTF-8").of(utf8);
}

}  // namespace gw::scene
