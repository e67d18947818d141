// Several texture units, textures looked up with r, and their states. Does not choose commands:
// suites do.
#pragma once

#include "conformance/generate/draw.h"

namespace gw::conformance {

// Textures of a kind, of one or more levels.
TextureRef any_depths(Random& random);
TextureRef any_cube(Random& random);
TextureRef any_volume(Random& random);

/// A state for a texture of any kind.
TextureState any_state_with_r(Random& random, const TextureRef& texture);
/// Matrices that turn s, t (0 .. 1) into directions and depths on both sides of 0.
void turn(Random& random, TextureState& state);
/// Any rule for each coordinate.
void any_rules(Random& random, TextureState& state);

/// The mesh with coordinates of three more units.
MeshRef with_units(Random& random, const Mesh& mesh);
/// Textures and states of all units; some are off.
void any_units(Random& random, State& state, Draw& draw);
/// Adds a rectangle of pixels with the textures of the draw.
void also_pixels(Script& script, const Draw& draw);

PointParameters any_point_parameters(Random& random, double depth);

}  // namespace gw::conformance
