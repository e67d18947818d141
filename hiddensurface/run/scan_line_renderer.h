// The scan-line renderer of eq. 3 [K3s]: visible spans line by line, every pixel of them shaded.
// The quality that multi-pass aims at. No shadows, fog or translucency: eq. 3 has none.
#pragma once

#include "gw/command_list.h"
#include "gw/profile.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

namespace gw::hiddensurface {

/// The picture as spans of colours on the scene's background, depth test off. Colours are clamped
/// once, to nearest. The jitter moves the scene by less than a pixel, as the machine's own does:
/// pictures to be averaged.
CommandList scan_line_picture(const scene::Scene& scene, const scene::View& view,
                              const Profile& profile, const JitterState& jitter = {});

}  // namespace gw::hiddensurface
