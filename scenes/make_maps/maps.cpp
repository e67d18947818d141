#include "scenes/make_maps/maps.h"

#include "scenes/make_maps/materials.h"

namespace gw::maps {

image::Picture NamedMap::picture() const { return paint(width, height, at); }

const std::vector<NamedMap>& maps() {
    static const std::vector<NamedMap> all{
        {"brick.png", 256, 256, brick},
        {"checker.png", 256, 256, checker},
        {"granite.png", 256, 256, granite},
        {"landscape.png", 256, 256, landscape},
        {"marble.png", 256, 256, marble},
        {"marble_gloss.png", 256, 256, marble_gloss},
        {"red.png", 128, 128, red},
        {"studio.png", 256, 256, studio},
        {"white_marble.png", 256, 256, white_marble},
        {"wood.png", 256, 256, wood},
    };
    return all;
}

}  // namespace gw::maps
