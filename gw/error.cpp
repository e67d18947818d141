#include "gw/error.h"

namespace gw {
namespace {

/// A zero byte would end the C string of what() too early.
std::string without_zeros(std::string text) {
    for (std::size_t at = text.find('\0'); at != text.npos; at = text.find('\0', at))
        text.replace(at, 1, "\\x00");
    return text;
}

}  // namespace

Error::Error(std::string_view file, int line, std::string_view what)
    : std::runtime_error(without_zeros(at_line(file, line, what))) {}

std::string at_line(std::string_view file, int line, std::string_view what) {
    std::string text(file);
    if (line > 0) text += ":" + std::to_string(line);
    text += ": ";
    text += what;
    return text;
}

}  // namespace gw
