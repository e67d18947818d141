// A library's message as one line of a sentence. Messages of damaged files may have megabytes.
#pragma once

#include <algorithm>
#include <string>

namespace gw::image::oiio {

inline std::string one_line(std::string text) {
    constexpr std::size_t most = 200;
    while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
    if (text.size() > most) text = text.substr(0, most) + "...";
    std::ranges::replace(text, '\n', ' ');
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 32 || c == 127; }, '?');
    return text.empty() ? "the library gives no reason" : text;
}

}  // namespace gw::image::oiio
