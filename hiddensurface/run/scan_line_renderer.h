// The scan-line renderer of eq. 3 [K3s]: finds visible spans line by line and shades every pixel.
// Multi-pass rendering aims at this quality. No shadows, fog or translucency: eq. 3 has none.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

namespace gw::hiddensurface {

/// The picture as spans of colours on the scene's background, depth test off. Colours are clamped
/// once and rounded to nearest. The jitter moves the scene by less than a pixel, like the machine's
/// own, for pictures that will be averaged.
CommandList scan_line_picture(const scene::Scene& scene, const scene::View& view,
                              const Profile& profile, const JitterState& jitter = {});

}  // namespace gw::hiddensurface
