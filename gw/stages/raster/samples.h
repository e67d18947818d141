// The samples of a pixel: their places, those that a fragment keeps, and their mean.
// docs/manual/samples.md. Does not draw.
#pragma once

#include "gw/planes.h"
#include "gw/stages/resolve.h"

#include <cstdint>
#include <span>

namespace gw {

/// Samples of a pixel, a bit each: bit k is sample k.
using SampleMask = std::uint8_t;
constexpr SampleMask all_samples(int samples) { return SampleMask((1u << samples) - 1); }

/// The shift of a primitive, in sub-pixels, that brings the place of sample k of `samples` to the
/// centre of its pixel.
JitterState sample_shift(int samples, int k, int subpixel_bits);

/// The samples that a fragment of this alpha keeps, by alpha to coverage and the coverage test.
SampleMask kept_samples(const Resolved& resolved, std::uint32_t alpha);
/// The samples that the coverage test keeps.
SampleMask tested_samples(const Resolved& resolved);
/// The least alpha with which sample k stays under alpha to coverage.
std::uint32_t least_alpha(int samples, int k, int color_bits);

/// One value for all samples of a pixel: the mean of colours, depth and stencil value of sample 0.
Planes one_of_each(std::span<const Planes> samples);

}  // namespace gw
