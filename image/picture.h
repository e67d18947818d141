// A picture before it becomes a file: the integers of the frame buffer, unchanged. Tone is an
// explicit step. Does not read or write files.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <vector>

namespace gw::image {

/// Interleaved channels, bottom row first; each value is 0 .. 2^bits - 1.
struct Picture {
    int width = 0, height = 0;
    int channels = 3;  ///< 1 grey; 3 R, G, B; 4 and alpha, in PNG only
    int bits = 8;      ///< 1 .. 16
    std::vector<std::uint16_t> values;
    bool operator==(const Picture&) const = default;
};

/// R, G, B of a colour plane of `bits` bits. Alpha belongs to blending and is left out.
Picture picture_of(const std::vector<Rgba>& color, int width, int height, int bits);

/// Display adjustments, applied on request only: v becomes (v 2^exposure) ^ (1/gamma), v in 0 .. 1,
/// clamped.
struct Tone {
    double exposure = 0;  ///< stops
    double gamma = 1;     ///< > 0
    bool operator==(const Tone&) const = default;
};
Picture toned(Picture picture, const Tone& tone);

/// The mean of every square of `factor` x `factor` pixels, to nearest; squares at the right and top
/// may be cut.
Picture downscaled(const Picture& picture, int factor);

}  // namespace gw::image
