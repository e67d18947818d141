// A pixel's history as a table and as JSON. Pixels in picture coordinates, top left first.
#pragma once

#include "inspect/replay/pixel_history.h"

#include <nlohmann/json.hpp>

namespace gw::inspect {

/// Rows of words, the first of them the header: pass, command, what happened, values before and
/// after. A plane whose values stay the same shows one value; accumulation is left out where it
/// stays 0.
std::vector<std::vector<std::string>> history_rows(const std::vector<PixelEvent>& events);

/// {"x", "y", "profile", "width", "height", "events": [...]}
nlohmann::ordered_json history_json(const Recording& recording, int x, int y,
                                    const std::vector<PixelEvent>& events);

}  // namespace gw::inspect
