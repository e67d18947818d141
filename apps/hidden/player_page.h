// The player: a page that plays step logs in a browser, from disk (web/player). Does not make logs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gw::apps {

/// The page with these logs (lines of JSON, docs/hiddensurfaces.md) in it, packed. Empty if the
/// build has no pages: Node was missing.
std::string player_page(const std::vector<std::string>& logs);

std::string_view embedded_page(std::string_view name);  ///< written by CMake

}  // namespace gw::apps
