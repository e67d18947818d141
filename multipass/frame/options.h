// The options of the driver. Plain data. Does not describe the scene.
#pragma once

#include "gw/machine.h"
#include "multipass/passes/passes.h"
#include "scene/draw/view.h"

#include <functional>
#include <optional>
#include <vector>

namespace gw::multipass {

/// Whether coincident faces are added once (one_winner.h). Auto counts winners first; Never and
/// Always need no count.
enum class OneWinner { Auto, Never, Always };

/// The traced component of a frame [K4], which the pass of PassAction::Trace adds: a colour for
/// each pixel of the view, bottom row first. The scene is at the sample's moment; the machine's
/// planes may be used.
using Trace = std::function<std::vector<Rgba>(Machine&, const scene::Scene&, const scene::View&,
                                              const JitterState&)>;

struct Options {
    Renderer renderer = Renderer::Multipass;
    std::optional<PassList> pass_list;  ///< instead of the renderer's
    OneWinner one_winner = OneWinner::Auto;
    Translucency translucency = Translucency::Sorted;
    Trace trace;  ///< empty: passes of PassAction::Trace add nothing
    /// The least number of superposed pictures; soft lights, lens, motion and glare of a scene may
    /// need more.
    int samples = 1;
    bool weighted = false;  ///< their mean by tent_weights [K4a]
};

}  // namespace gw::multipass
