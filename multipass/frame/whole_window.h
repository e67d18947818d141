// A fragment on every pixel of the window: to ask the stencil buffer, to change it. Does not
// colour.
#pragma once

#include "gw/command_list.h"

namespace gw::multipass {

/// A triangle around the window of any view, at the farthest Z, which is that of the background.
/// What the state says of tests, masks and jitter holds, what it says of geometry does not.
inline void add_whole_window(CommandList& list, State state) {
    static const MeshRef triangle = make_mesh({.positions = {{-2, -2, 1}, {6, -2, 1}, {-2, 6, 1}}});
    state.projection = dmat4(1);
    state.clip_planes = {};
    state.cull = {};
    state.color_source = ColorSource::Vertex;
    list.add(SetState{state});
    list.add(Draw{.mesh = triangle});
}

}  // namespace gw::multipass
