// A material's lists of maps, with the statement of each. Does not look for files.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

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

/// Calls visit for each map of a material's colours.
template <class Visit>
void for_each_color_map(Material& m, const Visit& visit) {
    for (std::vector<Map>* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke})
        for (Map& map : *maps) visit(map);
}

/// What names a map in its file: `statement`, or its place in glTF, and the picture's file.
std::string map_words(const Map& map, std::string_view statement);

/// Takes maps without texture out of their materials, if Map::may_lack. One warning for each file that
/// names some.
void leave_out_missing(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
