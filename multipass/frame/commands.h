// From steps to commands: the state, the draws, the clear of one run of a pass.
// Does not decide which passes there are, and does not find shadows.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "multipass/frame/placed_model.h"
#include "multipass/passes/schedule.h"
#include "multipass/ties/tied_pixels.h"

namespace gw::multipass {

/// What holds for all passes of a frame.
struct FrameRules {
    vec3 background{0, 0, 0};
    /// One winner per pixel where faces coincide, by a bit of the stencil: see one_winner.h.
    bool one_winner = false;
    /// Where they coincide; null: not known, it may be everywhere.
    const TiedPixels* tied = nullptr;
    int stencil_bits = 8;
    /// White images that the accumulation buffer holds.
    int most_images = 128;
};

/// BeginPass and SetState.
void begin_pass(CommandList& list, const std::string& name, const State& state = {});

/// The commands of one step: BeginPass, SetState, Clear, Draw. None where no part is concerned and
/// nothing is cleared.
void add_step(CommandList& list, const Stage& stage, const Step& step, const FrameRules& rules);

/// The pass's state in this view: what its fields say on top of the state that all passes share.
State state_of(const Stage& stage, const Step& step);

/// How the part's map is looked up in a pass; the initial state where it has none.
TextureState lookup_of(const Stage& stage, const Step& step, std::size_t part);

/// The draw of a part, or of a portion of it, in a pass: with its material, lights and map; black
/// where nothing is added.
Draw draw_of(const Stage& stage, const Step& step, const Portion& portion);
/// Black, with the object's own alpha.
Draw black_draw(const Stage& stage, const Portion& portion);

}  // namespace gw::multipass
