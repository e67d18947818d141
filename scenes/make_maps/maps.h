// The maps that the scenes use, by the names of their files.
#pragma once

#include "image/picture.h"

#include <string>
#include <vector>

namespace gw::maps {

struct NamedMap {
    std::string file;  ///< in scenes/maps/
    int width, height;
    dvec3 (*at)(dvec2 st);
    image::Picture picture() const;
};

const std::vector<NamedMap>& maps();

}  // namespace gw::maps
