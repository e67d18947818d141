// The frame of the pages that commands write: the language, the title, the style of all pages of the
// project. Does not fill them.
#pragma once

#include <string>
#include <string_view>

namespace gw::apps {

/// A page up to the begin of its <main>. `title` is text; `head` is HTML, and stands first in the
/// page's head. Light or dark as the reader's system is.
std::string page_begin(std::string_view title, std::string_view head = {},
                       std::string_view language = "en");
/// What closes it.
inline constexpr std::string_view page_end = "</main>\n</html>\n";

/// A style sheet by its name: "page.css". Written by CMake.
std::string_view embedded_style(std::string_view name);

}  // namespace gw::apps
