// The profiles of our turned vessels. All are 1 high and stand on y = 0; ours, drawn for these
// scenes.
#pragma once

#include "scene/shapes/lathe.h"

namespace gw::scene {

Profile bottle_profile();
Profile bowl_profile();
Profile goblet_profile();
Profile pedestal_profile();  ///< a round column with base and plate, solid
Profile vase_profile();

}  // namespace gw::scene
