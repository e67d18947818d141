// A fragment on every pixel of the window: to ask the stencil buffer, to change it, to fill.
// Does not set the state that the fragments meet.
#pragma once

#include "gw/command_list.h"
#include "scene/view.h"

namespace gw::multipass {

/// One span per row, all of one colour and depth.
inline WriteSpans whole_window(const scene::View& view, const Rgba& color = {}, std::uint32_t depth = 0) {
    WriteSpans spans{.colors = {color}, .depth = depth};
    for (int y = 0; y < view.height; ++y) spans.spans.push_back({.x = 0, .y = y, .length = view.width});
    return spans;
}

}  // namespace gw::multipass
