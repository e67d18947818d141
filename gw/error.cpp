#include "gw/error.h"

#include "gw/escape_controls.h"

namespace gw {

Error::Error(std::string_view file, int line, std::string_view what)
    : std::runtime_error(escape_controls(at_line(file, line, what))) {}

std::string at_line(std::string_view file, int line, std::string_view what) {
    std::string text(file);
    if (line > 0) text += ":" + std::to_string(line);
    text += ": ";
    text += what;
    return text;
}

}  // namespace gw
