// The item buffer [K4i]: the identifier of the polygon that each pixel shows, drawn by the machine.
// Equation 5, shadow maps and comparisons share it. Does not trace.
#pragma once

#include "gw/machine.h"
#include "scene/draw/draw_commands.h"

#include <cstdint>
#include <vector>

namespace gw::scene {

/// A pixel holds 24 bits: three channels of eight, on every profile. A scene with more identifiers
/// is drawn several times, each time for the next 24 bits.
inline constexpr int bits_per_pass = 24;

/// The identifiers of polygon_ids by pixel, bottom row first; 0 is the background. Objects with
/// d < 1 are left out. `jitter` is that of the passes that use the identifiers. `bits` of a pass:
/// 1 .. 24; tests use fewer than 24. Overwrites the machine's colour and depth planes.
std::vector<std::uint32_t> draw_item_buffer(Machine& machine, const Scene& scene, const View& view,
                                            const JitterState& jitter, int bits = bits_per_pass);

}  // namespace gw::scene
