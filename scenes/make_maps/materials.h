// The colours of the maps: each function is a colour at s, t in [0,1), and repeats, so that the map
// can be tiled.
#pragma once

#include "scenes/make_maps/paint.h"

namespace gw::maps {

/// Red lacquer, slightly uneven. Has hardly any green or blue, so that it turns every colour it
/// modulates red [K2].
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

/// GL's sphere map of a photographer's studio [K3]: s, t is the direction of the ball's normal, as
/// the eye sees it. Dark, with a soft box above, a window with bars to the left, a row of lamps to
/// the right, a floor.
Color studio(dvec2 st);

/// The same of a landscape: sky, sun behind the eye's left shoulder, hills, ground.
Color landscape(dvec2 st);

}  // namespace gw::maps
