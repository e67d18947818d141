// What can be asked of the driver besides the scene itself. Plain data.
#pragma once

#include "gw/machine.h"
#include "multipass/passes/passes.h"
#include "scene/draw/view.h"

#include <functional>
#include <optional>
#include <vector>

namespace gw::multipass {

/// Coincident faces added once. Auto counts winners first; Never and Always spare the count.
enum class OneWinner { Auto, Never, Always };

/// The traced component of a frame [K4]: what the pass of PassAction::Trace adds, a colour for each
/// pixel of the view, bottom row first. The scene is at the sample's moment; the machine's planes
/// may be used.
using Trace = std::function<std::vector<Rgba>(Machine&, const scene::Scene&, const scene::View&,
                                              const JitterState&)>;

struct Options {
    Renderer renderer = Renderer::Multipass;
    std::optional<PassList> passes;  ///< in place of the renderer's
    OneWinner one_winner = OneWinner::Auto;
    Translucency translucency = Translucency::Sorted;
    Trace trace;  ///< empty: passes of PassAction::Trace add nothing
    /// superposed pictures, at least; a scene's soft lights, lens, motion and glare may ask for
    /// more
    int samples = 1;
    bool weighted = false;  ///< their mean by tent_weights [K4a]
};

}  // namespace gw::multipass
