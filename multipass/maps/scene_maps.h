// Reflection and refraction maps generated from the scene itself [K3.1] (Blinn, Newell 1976): the
// passes draw six views from an object's centre, and the host makes a sphere map of them. Does not
// draw the picture.
#pragma once

#include "gw/machine.h"
#include "multipass/frame/options.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

namespace gw::multipass {

/// Whether the passes look up a generated map that is not filled in.
bool has_scene_maps(const scene::Scene& scene, const Options& options);

/// Fills in every generated map (scene::Map::from_scene) that the passes look up; its objects get
/// materials of their own. The maps hold for views in the same direction as `view`. The six views
/// leave out the object itself, generated maps of other objects, glare, and superposition: they are
/// one sample, in the middle of the exposure. Overwrites the machine's planes.
scene::Scene with_scene_maps(Machine& machine, const scene::Scene& scene, const scene::View& view,
                             const Options& options);

}  // namespace gw::multipass
