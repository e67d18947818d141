// Reflection and refraction maps generated from the scene itself [K3.1]: what is seen from an
// object's centre, drawn by the passes on the machine in six views, and made a sphere map on the
// host. Blinn, Newell
// 1976. Does not draw the picture.
#pragma once

#include "gw/machine.h"
#include "multipass/frame/options.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

namespace gw::multipass {

/// Whether the passes look up any generated map that is not filled in.
bool has_scene_maps(const scene::Scene& scene, const Options& options);

/// The scene with every generated map (scene::Map::from_scene) that the passes look up filled in;
/// its objects have materials of their own then. The maps hold for views that look the same way as
/// `view`. Left out of the six views: the object itself, generated maps of the others, glare, and
/// superposition (one sample, in the middle of the exposure). The machine's planes are used, and
/// left as they come.
scene::Scene with_scene_maps(Machine& machine, const scene::Scene& scene, const scene::View& view,
                             const Options& options);

}  // namespace gw::multipass
