// A sphere map from six views, for the machine's SphereMap and RefractionMap
// (docs/manual/texture.md). Computes in double and integers, so the texels are the same everywhere.
// Does not draw the views (scene_maps.h).
#pragma once

#include "gw/planes.h"
#include "gw/texture.h"
#include "scene/draw/view.h"

#include <array>
#include <string>
#include <vector>

namespace gw::multipass {

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

/// size x size texels of 16 bits, each the mean of 4 x 4 positions in it, to nearest. `color_bits`
/// of the picture.
TextureRef sphere_map(std::string name, const CubePicture& around, const dmat4& eye_from_world,
                      int size, int color_bits);

}  // namespace gw::multipass
