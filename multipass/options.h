// What can be asked of the driver besides the scene itself. Plain data.
#pragma once

#include "multipass/passes.h"

#include <optional>

namespace gw::multipass {

/// Coincident faces added once. Auto counts winners first; Never and Always spare the count.
enum class OneWinner { Auto, Never, Always };

struct Options {
    Renderer renderer = Renderer::Multipass;
    std::optional<PassList> passes;  ///< in place of the renderer's
    OneWinner one_winner = OneWinner::Auto;
    Translucency translucency = Translucency::Sorted;
    int samples =
        1;  ///< superposed pictures, at least; a scene's soft lights, lens, motion and glare may ask for more
};

}  // namespace gw::multipass
