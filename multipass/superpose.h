// Superposition of pictures in the accumulation buffer [K1]: sums with weight 1, one division at the end, so
// one rounding. Does not know what is drawn (samples.h says what differs from picture to picture).
#pragma once

#include "gw/machine.h"
#include "multipass/samples.h"

#include <functional>

namespace gw::multipass {

/// How many white pictures the profile's accumulation buffer holds: 128 on vgx.
int most_pictures(const Profile& profile);

/// How a count is superposed. `samples` is the count, rounded up where groups must be of one size.
struct Superposition {
    int samples = 1;
    int groups = 1;  ///< more than one: means of groups, read back, are averaged again and round twice
};

/// Of pictures which add `images` (0: they draw in the frame buffer, and count as 1) each. Throws Error where
/// the count is less than 1 or even the groups' means do not fit.
Superposition superposition(const Profile& profile, int count, int images);

/// Calls `draw` for every sample and leaves the mean in the colour plane. images = 0: what `draw` leaves in
/// the colour plane is added; else `draw` adds `images` pictures itself, to an accumulation buffer that was
/// cleared before.
Superposition superpose(Machine& machine, int count, int images,
                        const std::function<void(const Sample&)>& draw);

}  // namespace gw::multipass
