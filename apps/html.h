// Text on its way into a page. Does not write pages.
#pragma once

#include <string>
#include <string_view>

namespace gw::apps {

/// As it is read, whatever it says: in the text of an element or in an attribute in double or single quotes.
std::string escaped(std::string_view text);

}  // namespace gw::apps
