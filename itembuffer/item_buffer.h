// The item buffer [K4i]: for every pixel the identifier of the polygon that it shows, drawn by the
// machine.
// Does not trace.
#pragma once

#include "gw/machine.h"
#include "scene/draw/draw_commands.h"

#include <cstdint>
#include <vector>

namespace gw::itembuffer {

/// A pixel holds 24 bits: three channels of eight, on every profile. Scenes with more identifiers
/// are drawn several times, each time the next 24 bits.
inline constexpr int bits_per_pass = 24;

/// Identifiers of scene::polygon_ids, 0 where there is none, bottom row first; objects with d < 1
/// left out.
/// `jitter` as in the passes that it serves. `bits`: of a pass, 1 .. 24; fewer than 24 are for
/// tests. The machine's colour and depth planes are used.
std::vector<std::uint32_t> draw_item_buffer(Machine& machine, const scene::Scene& scene,
                                            const scene::View& view, const JitterState& jitter,
                                            int bits = bits_per_pass);

}  // namespace gw::itembuffer
