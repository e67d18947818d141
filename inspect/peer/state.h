// The state of a command list as OpenGL's. Does not set what belongs to a draw (matrices, texture,
// fog): draw.h.
#pragma once

#include "gw/profile.h"
#include "gw/state.h"

namespace gw::peer {

/// Sets viewport, clip planes, culling, sizes, tests, blending and masks. Throws Error for what
/// OpenGL cannot express here.
void apply(const State& state, int width, int height);

}  // namespace gw::peer
