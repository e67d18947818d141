// Reads a step of a log from a line of JSON, as gw hidden or another program wrote it. Strict: a
// member of another name, kind or size is an error. Does not know the scene: play.h checks the names
// of polygons and the window.
#pragma once

#include "hiddensurface/run/step_json.h"

#include <nlohmann/json.hpp>

namespace gw::hiddensurface {

/// Throws Error "not JSON at column N ...; expected what".
nlohmann::ordered_json json_of_line(const std::string& line);

/// The step of such a line. Only `kind` is required. Throws Error "what; expected what".
Step step_of(const nlohmann::ordered_json& json, const PictureGrid& grid);
Step step_of_line(const std::string& line, const PictureGrid& grid);

}  // namespace gw::hiddensurface
