// Plays a recording on another implementation of OpenGL and on the machine. Only in builds with
// gw::peer.
#pragma once

#include "inspect/recording/recording.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gw::apps {

struct OnOpengl {
    std::string implementation;  ///< "osmesa", "gl" or a path (inspect/peer/player.h)
    std::optional<std::pair<int, int>> passes;  ///< compared ones; others are executed only
};

/// The differences after the pass that has most of them.
struct WorstPass {
    std::string name;
    std::uint64_t pixels = 0;              ///< of its colours
    std::vector<std::uint64_t> distances;  ///< of its colours, bottom row first
};

struct OpenglComparison {
    std::string text;  ///< tables: pixels after each pass, and by cause
    bool same = true;  ///< no pixel of colour, Z and stencil differs
    WorstPass worst;
};

/// Compares colour, Z and stencil after each pass with the reference machine, which tells what painted
/// each pixel. Throws Error if OpenGL cannot play it, and for passes that the recording lacks.
OpenglComparison compare_on_opengl(const inspect::Recording& recording, const OnOpengl& options);

}  // namespace gw::apps
