// What a scene becomes when its textures are there. Then every renderer draws the same: opacity that
// varies over a surface is cut into objects of one d each [GLTF2 3.9.4], mirrored maps are unfolded, and
// mirrored objects keep their sides.
#pragma once

#include "scene/film.h"
#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <vector>

namespace gw::scene {

/// Once, after image::load_textures. Films cut the scene anew at each time.
void finish(Scene& scene, std::vector<Film>& films, Warnings& warnings);
void finish(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
