// A material's lists of maps, with the statement of each.
#pragma once

#include "scene/scene.h"

#include <string_view>

namespace gw::scene {

/// Calls visit(statement, maps) for each list of a material, which is constant or not.
template <class SomeMaterial, class Visit>
void for_each_map_list(SomeMaterial& m, const Visit& visit) {
    visit("map_Ka", m.map_Ka);
    visit("map_Kd", m.map_Kd);
    visit("map_Ks", m.map_Ks);
    visit("map_Ke", m.map_Ke);
    visit("refl", m.refl);
    visit("refraction", m.refraction);
    visit("map_d", m.map_d);
    visit("metallicRoughnessTexture", m.map_metal);
}

/// What names a map in its file: `statement`, or its place in glTF, and the picture's file.
std::string map_words(const Map& map, std::string_view statement);

}  // namespace gw::scene
