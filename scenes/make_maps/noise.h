// Noise that repeats, from an integer hash: the same numbers on every machine. Does not use libm.
#pragma once

#include "gw/base/types.h"

#include <cstdint>

namespace gw::maps {

/// 32 well-mixed bits of two integers and a seed.
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

/// The same as a number in [0, 1).
double hash_unit(int x, int y, std::uint32_t seed);

/// Smooth value noise in [0, 1): random at the corners of a lattice of `cells` cells in [0,1)^2,
/// which repeats.
double noise(dvec2 st, ivec2 cells, std::uint32_t seed);

/// Sum of `octaves` of noise, each twice as fine and half as strong, in [0, 1).
double fractal(dvec2 st, ivec2 cells, int octaves, std::uint32_t seed);

}  // namespace gw::maps
