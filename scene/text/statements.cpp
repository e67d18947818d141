#include "scene/text/statements.h"

#include "gw/base/cancel.h"
#include "gw/error.h"

#include <cstring>

namespace gw::scene {

Statements::Statements(std::string file, std::string_view text)
    : file_(std::move(file)), at_(text.data()), end_(text.data() + text.size()) {}

void Statements::fail(std::string_view what) const { throw Error(file_, line_, what); }

std::string_view trim(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

namespace {

constexpr int lines_between_looks = 4096;

std::string_view physical_line(const char*& at, const char* end) {
    const auto* newline = static_cast<const char*>(std::memchr(at, '\n', std::size_t(end - at)));
    const char* const stop = newline ? newline : end;
    const std::string_view line = trim({at, std::size_t(stop - at)});
    at = newline ? newline + 1 : end;
    return line;
}

}  // namespace

// A line whose last character is '\' goes on in the next; a comment does not.
std::string_view Statements::logical_line() {
    line_ = next_line_++;
    std::string_view line = physical_line(at_, end_);
    if (!line.ends_with('\\') || line.starts_with('#')) return line;
    joined_.clear();
    while (line.ends_with('\\') && at_ < end_) {
        joined_.append(line, 0, line.size() - 1).append(1, ' ');
        line = physical_line(at_, end_);
        ++next_line_;
    }
    if (line.ends_with('\\')) line.remove_suffix(1);
    return trim(joined_.append(line));
}

bool Statements::next() {
    while (at_ < end_) {
        if (next_line_ % lines_between_looks == 0) end_if_canceled();
        rest_ = logical_line();
        keyword_ = take_word(rest_);
        rest_ = trim(rest_);
        if (!keyword_.empty()) return true;
    }
    return false;
}

}  // namespace gw::scene
