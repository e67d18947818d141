// Anti-aliasing by superposition: the picture is drawn several times, moved by less than a pixel, and
// averaged in the accumulation buffer [K1]. Does not know what is drawn.
#pragma once

#include "gw/machine.h"

#include <functional>
#include <vector>

namespace gw::multipass {

/// Movements in sub-pixel units, evenly spread over the pixel: 4^subpixel_bits of them fill its grid. One: no
/// movement.
std::vector<JitterState> sample_positions(int count, int subpixel_bits);

/// How many white pictures the profile's accumulation buffer holds: 128 on vgx.
int most_samples(const Profile& profile);

/// Calls `draw` once per sample with a machine that moves what it draws, adds up with weight 1 and returns
/// the mean, which rounds once. One sample: the picture as it is. Throws Error for a count outside 1 ..
/// most_samples.
void render_samples(Machine& machine, int count, const std::function<void(Machine&)>& draw);

}  // namespace gw::multipass
