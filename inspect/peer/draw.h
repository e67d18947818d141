// A draw through OpenGL's glBegin and glEnd. Does not set the rest of the state: state.h.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"

namespace gw::peer {

/// `textured`: a texture is bound. Throws Error for lighting of two sides.
void draw(const Draw& draw, const State& state, const Profile& profile, int width, int height,
          bool textured);

}  // namespace gw::peer
