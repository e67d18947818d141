// What the maps show: each function is a colour at s, t in [0,1), and repeats, so that the map can
// be tiled.
#pragma once

#include "scenes/make_maps/paint.h"

namespace gw::maps {

/// Red lacquer, a little uneven: no green or blue worth the name, so that what it modulates turns
/// red [K2].
Color red(dvec2 st);

/// Green marble and its light veins; where the polished ground is 1 and the dull veins are dark
/// [K3.1].
Color marble(dvec2 st);
Color marble_gloss(dvec2 st);

/// White marble with grey veins.
Color white_marble(dvec2 st);

/// Planks of wood, four across, s along the grain.
Color wood(dvec2 st);

/// Stone tiles, light and dark, two by two.
Color checker(dvec2 st);

/// Eight courses of four bricks.
Color brick(dvec2 st);

/// Speckled granite.
Color granite(dvec2 st);

}  // namespace gw::maps
