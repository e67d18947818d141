// Superposition of pictures in the accumulation buffer [K1]: they are summed with weight 1 and
// divided once, so rounded once. Does not draw (samples.h has the values that differ between the
// pictures).
#pragma once

#include "gw/machine.h"
#include "multipass/frame/samples.h"

#include <functional>
#include <vector>

namespace gw::multipass {

/// How many white pictures the profile's accumulation buffer holds: 128 on vgx.
int most_pictures(const Profile& profile);

/// The pictures and their groups. `samples` is rounded up if groups must have one size.
struct Superposition {
    int samples = 1;
    /// More than one: the means of groups are read back and averaged again, a second rounding.
    int groups = 1;
};

/// The superposition of `count` pictures that add `images` each to the accumulation buffer. Images
/// 0: a picture is drawn in the frame buffer and counts as 1. Throws Error if the count is less
/// than 1, or the means of the groups do not fit either.
Superposition superposition(const Profile& profile, int count, int images);

/// Integer weights of `count` samples [K4a]: a tent over the pixel, highest for sub-pixel positions
/// at its centre. Each weight is at least 1, their sum at most `most`. Throws Error if count is
/// larger than `most`.
std::vector<int> tent_weights(int count, int subpixel_bits, int most);

/// tent_weights if `weighted` and there is more than one sample; else none.
std::vector<int> weights_of(int samples, bool weighted, const Profile& profile);

/// Calls `draw` for every sample and leaves the mean in the colour plane. With images = 0 `draw`
/// leaves a picture in the colour plane, which is added; else `draw` adds `images` pictures itself
/// to the cleared accumulation buffer. `weights` of the samples: for pictures in the frame buffer
/// that need no groups; empty: all are equal.
Superposition superpose(Machine& machine, int count, int images,
                        const std::function<void(const Sample&)>& draw,
                        const std::vector<int>& weights = {});

}  // namespace gw::multipass
