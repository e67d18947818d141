// Coincident faces: if two of them have the same Z at a pixel, both pass Equal, and an additive
// pass would add twice. docs/passes.md, "One winner per pixel". Does not decide whether the scheme
// is needed: the driver asks add_winner_count.
//
// One pass finds them: it counts the winners of every pixel in the stencil buffer. If a pixel has
// two, the first face in the order of objects takes it in every additive pass. The stencil's top
// bit marks the pixels that are taken. Every opaque object is drawn then, in black if the pass does
// not concern it, so that the winner is the same in all passes. Few pixels tie in most pictures, so
// the count is read back (tied_pixels). Only they get the scheme, with the few triangles near them;
// all others get the pass unchanged.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "multipass/steps/placed_model.h"
#include "multipass/steps/schedule.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::multipass {

/// The key of the count's read-back: the number of winners of each pixel.
inline constexpr std::uint32_t winners_key = 0;

struct FrameRules;

/// Two passes to run after the depth pass. They keep its Z, and leave the stencil 0 as they found
/// it.
void add_winner_count(CommandList& list, const PlacedModel& placed, const FrameRules& rules);

/// The number of fragments that an additive pass would write beyond one per pixel. `reports` are
/// those of the two passes.
std::uint64_t surplus_winners(std::span<const PassReport> reports);

/// The commands of one step, as add_step(). If the rules ask for one winner, an additive step of
/// opaque parts adds once on each pixel.
void add_step_with_one_winner(CommandList& list, const PlacedModel& placed, const Step& step,
                              const FrameRules& rules);

/// Pixels with several fragments of the nearest Z, and the triangles that may have drawn them.
struct TiedPixels {
    std::vector<Span> spans;  ///< a pixel each
    /// The triangles of opaque parts near such a pixel, in their order; parts of lines or points
    /// whole.
    std::vector<Portion> portions;
};

/// `winners`: the number of fragments with the nearest Z, by pixel of the view, bottom row first.
TiedPixels tied_pixels(const PlacedModel& placed, std::span<const std::uint32_t> winners);

/// Whether tied pixels can be distinguished: the stencil has two spare bits, and a triangle drawn
/// alone has the same fragments as in its mesh.
bool can_mark_ties(const PlacedModel& placed, int stencil_bits);

}  // namespace gw::multipass
