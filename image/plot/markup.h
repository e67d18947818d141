// Escapes text for HTML and SVG. Does not write either.
#pragma once

#include <string>
#include <string_view>

namespace gw::plot {

/// The text for an element, or for an attribute in double or single quotes. It reads back unchanged.
std::string escaped(std::string_view text);

}  // namespace gw::plot
