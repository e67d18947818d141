// What pictures of pixmaps as textures and as strips have in common. For display.cpp and
// strips.cpp.
#pragma once

#include "gw/command_list.h"
#include "scene/draw/view.h"

namespace gw::radiosity {

/// Colours of vertices, no light, sides that do not emit left out.
State picture_state(const scene::View& view);
void begin_picture(CommandList& list, const char* name, const State& state, const vec3& background);
/// The identifier that display.h promises.
void name_figure(Draw& draw, std::uint32_t pixmap);

}  // namespace gw::radiosity
