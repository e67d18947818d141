// [film] and [[track]]: values of a scene at keys in time.
#pragma once

#include "scene/film.h"
#include "scene/toml/toml_value.h"

#include <optional>
#include <vector>

namespace gw::scene {

/// None without tracks. The scene is counted from `origin`. Throws Error from the key's line.
std::optional<Film> read_film(const TomlValue* film, const std::vector<const TomlValue*>& tracks,
                              const Scene& scene, const dvec3& origin);

}  // namespace gw::scene
