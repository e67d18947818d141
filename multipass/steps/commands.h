// From steps to commands: the state, the clear and the draws of one run of a pass. Does not choose
// the passes, finds no shadows, and adds coincident faces each (effects/one_winner.h).
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "multipass/steps/placed_model.h"
#include "multipass/steps/schedule.h"

#include <functional>
#include <optional>
#include <string>

namespace gw::multipass {

struct TiedPixels;

/// Rules for all passes of a frame.
struct FrameRules {
    vec3 background{0, 0, 0};
    /// One winner per pixel if faces coincide, by a bit of the stencil: see one_winner.h.
    bool one_winner = false;
    /// The pixels on which they coincide; null: unknown, assume every pixel.
    const TiedPixels* tied = nullptr;
    int stencil_bits = 8;
    /// White images that the accumulation buffer holds.
    int most_images = 128;
    /// Executes a long list and empties it, so that memory does not follow the number of parts;
    /// empty: lists grow.
    std::function<void(CommandList&)> cut{};
};

/// Cuts a list that is long, if the rules say how.
void cut_if_long(CommandList& list, const FrameRules& rules);

/// BeginPass and SetState.
void begin_pass(CommandList& list, const std::string& name, const State& state = {});

/// SetState if it differs from the one before.
class StateWriter {
public:
    explicit StateWriter(CommandList& list) : list_(&list) {}
    void set(const State& state) {
        if (last_ && *last_ == state) return;
        list_->add(SetState{state});
        last_ = state;
    }
    /// Others have set it.
    void forget() { last_.reset(); }

private:
    CommandList* list_;
    std::optional<State> last_;
};

/// BeginPass, and the step's Clear with its state.
void begin_step(CommandList& list, StateWriter& states, const PlacedModel& placed, const Step& step,
                const FrameRules& rules);
/// The draws of a step, with a state that has no texture yet.
void draw_step(CommandList& list, StateWriter& states, const PlacedModel& placed, const Step& step,
               State state, const FrameRules& rules);

/// The commands of one step: both of these. A step that draws no part and clears nothing has none.
void add_step(CommandList& list, const PlacedModel& placed, const Step& step,
              const FrameRules& rules);

/// The pass's state in this view: the state that all passes share, changed by the pass's fields.
State state_of(const PlacedModel& placed, const Step& step);

/// How the part's map is looked up in a pass; the initial state if it has none.
TextureState lookup_of(const PlacedModel& placed, const Step& step, std::size_t part);

/// The draw of a part, or of a portion of it, in a pass, with its material, lights and map. Black
/// if the pass adds nothing to the part.
Draw draw_of(const PlacedModel& placed, const Step& step, const Portion& portion);
/// Black, with the object's own alpha.
Draw black_draw(const PlacedModel& placed, const Portion& portion);

/// A fragment on every pixel of the window, at the farthest Z, which is that of the background. It
/// tests or changes the stencil everywhere and needs a state that writes no colour. The state's
/// tests, masks and jitter hold; its geometry does not.
void add_whole_window(CommandList& list, State state);

}  // namespace gw::multipass
