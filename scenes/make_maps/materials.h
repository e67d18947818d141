// The colours of the maps: each function is a colour at s, t in [0,1), and repeats, so that the map
// can be tiled.
#pragma once

#include "scenes/make_maps/paint.h"

namespace gw::maps {

/// Red lacquer, a little uneven. Has hardly any green or blue, so that everything it modulates
/// turns red [K2].
Color red(dvec2 st);

/// Green marble with light veins, and its gloss: 1 on the polished ground, dark in the dull veins
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
