// Pages that show data in a browser, from disk: web/player, web/compare, web/quiz. Does not make the data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gw::apps {

/// The page of this name, "player.html", with these texts in it, packed. Empty if the build has no
/// pages: Node was missing.
std::string page_with(std::string_view name, const std::vector<std::string>& texts);

/// A page without data. Empty if the build has none. Written by CMake.
std::string_view embedded_page(std::string_view name);

std::string base64(std::string_view bytes);

}  // namespace gw::apps
