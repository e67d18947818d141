// Coincident faces: where two of them have the same Z at a pixel, both pass Equal, and an additive pass would
// add twice. docs/passes.md, "One winner per pixel". Does not decide whether the scheme is needed: the driver
// asks count_winners.
//
// Most pictures have no such pixel, and one pass tells: it counts the winners of every pixel in the stencil
// buffer. Only where a pixel has two, every additive pass is drawn so that the first face in the order of
// objects takes the pixel: the stencil's top bit says that the pixel is taken. Every opaque object is drawn
// then, those that the pass does not concern in black, so that the winner is the same in all passes.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "multipass/schedule.h"
#include "multipass/stage.h"

#include <cstdint>
#include <span>

namespace gw::multipass {

/// Two passes to run after the depth pass (whose Z and the stencil, all 0, they leave as they were).
CommandList count_winners(const Stage& stage);

/// How many fragments too many an additive pass would write. `reports`: of the two passes, in order.
std::uint64_t surplus_winners(std::span<const PassReport> reports);

/// Whether all operations are Keep.
bool keeps_stencil(const StencilState& stencil);

/// Whether the scheme concerns this pass: drawn under Equal, blended, stencil kept.
bool is_additive(const Pass& pass);

/// The draws of an additive step with one winner per pixel, stencil bit 2^(stencil_bits - 1).
void add_one_winner_step(CommandList& list, const Stage& stage, const Step& step, int stencil_bits);

}  // namespace gw::multipass
