// Maps that repeat mirrored, for machines that only repeat: a texture of twice the width or height holds
// the mirror image beside the picture. Does not touch maps of opacity.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

namespace gw::scene {

/// Of all maps with textures. A side of more than 2048 texels is repeated without being mirrored, with
/// a warning.
void unfold_mirrored(Scene& scene, Warnings& warnings);

/// Calls visit for each map of a material's colours.
template <class Visit>
void for_each_color_map(Material& m, const Visit& visit) {
    for (std::vector<Map>* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke})
        for (Map& map : *maps) visit(map);
}

}  // namespace gw::scene
