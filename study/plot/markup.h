// Text on its way into a page or a drawing: HTML and SVG. Does not write either.
#pragma once

#include <string>
#include <string_view>

namespace gw::plot {

/// As it is read, whatever it says: in the text of an element or in an attribute in double or
/// single quotes.
std::string escaped(std::string_view text);

}  // namespace gw::plot
