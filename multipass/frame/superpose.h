// Superposition of pictures in the accumulation buffer [K1]: sums with weight 1, one division at
// the end, so one rounding. Does not know what is drawn (samples.h says what differs from picture
// to picture).
#pragma once

#include "gw/machine.h"
#include "multipass/frame/samples.h"

#include <functional>
#include <vector>

namespace gw::multipass {

/// How many white pictures the profile's accumulation buffer holds: 128 on vgx.
int most_pictures(const Profile& profile);

/// How a count is superposed. `samples` is the count, rounded up where groups must be of one size.
struct Superposition {
    int samples = 1;
    /// more than one: means of groups, read back, are averaged again and round twice
    int groups = 1;
};

/// Of pictures which add `images` (0: they draw in the frame buffer, and count as 1) each. Throws
/// Error where the count is less than 1 or even the groups' means do not fit.
Superposition superposition(const Profile& profile, int count, int images);

/// Integer weights of `count` samples [K4a]: the more the nearer a sample's sub-pixel position is
/// to the pixel's centre, as a tent falls to its border; at least 1 each, `most` together at most.
/// Throws Error where count is larger than `most`.
std::vector<int> tent_weights(int count, int subpixel_bits, int most);

/// tent_weights where weights are asked for and there is more than one sample; else none.
std::vector<int> weights_of(int samples, bool weighted, const Profile& profile);

/// Calls `draw` for every sample and leaves the mean in the colour plane. images = 0: what `draw`
/// leaves in the colour plane is added; else `draw` adds `images` pictures itself, to an
/// accumulation buffer that was cleared before. `weights`: of the samples, for pictures that draw
/// in the frame buffer and are not in groups; empty: all the same.
Superposition superpose(Machine& machine, int count, int images,
                        const std::function<void(const Sample&)>& draw,
                        const std::vector<int>& weights = {});

}  // namespace gw::multipass
