// Reflection and refraction maps generated from the scene itself [K3.1] (Blinn, Newell 1976). The
// passes draw six views from an object's centre, and the host makes a sphere map of them. Does not
// draw the picture.
#pragma once

#include "gw/machine.h"
#include "gw/planes.h"
#include "gw/texture.h"
#include "multipass/frame/options.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace gw::multipass {

/// Whether the passes look up a generated map that is not filled in.
bool has_scene_maps(const scene::Scene& scene, const Options& options);

/// Fills in every generated map (scene::Map::from_scene) that the passes look up; its objects get
/// materials of their own. The maps hold for views in the same direction as `view`. The six views
/// leave out the object itself, generated maps of other objects, glare, and superposition: they are
/// one sample, in the middle of the exposure. Overwrites the machine's planes.
scene::Scene with_scene_maps(Machine& machine, const scene::Scene& scene, const scene::View& view,
                             const Options& options);

/// The surroundings of a point: scene::cube_views, each with its picture, bottom row first.
struct CubePicture {
    std::array<scene::View, 6> views;
    std::array<std::vector<Rgba>, 6> colors;

    /// The pixel in a direction (world space, any length but 0); at an edge between two views, of
    /// the first.
    const Rgba& seen(const dvec3& direction) const;
};

/// The eye-space direction of position (s, t) in a sphere map; beyond the rim that of the rim,
/// straight ahead.
dvec3 direction_of(double s, double t);

/// A sphere map from six views, for the machine's SphereMap and RefractionMap
/// (docs/manual/texture.md). It has size x size texels of 16 bits, each the mean of 4 x 4 positions
/// in it, to nearest. Computed in double and integers, so the texels are the same everywhere.
/// `color_bits` of the picture.
TextureRef sphere_map(std::string name, const CubePicture& around, const dmat4& eye_from_world,
                      int size, int color_bits);

}  // namespace gw::multipass
