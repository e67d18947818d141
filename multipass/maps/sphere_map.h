// A sphere map from six views: what the machine's SphereMap and RefractionMap look up
// (docs/manual/texture.md). Does not draw the views: scene_maps.h does. Double and integers only,
// so the same texels everywhere.
#pragma once

#include "gw/planes.h"
#include "gw/texture.h"
#include "scene/draw/view.h"

#include <array>
#include <string>
#include <vector>

namespace gw::multipass {

/// What is seen from a point all around: scene::cube_views, each with its picture, bottom row
/// first.
struct CubePicture {
    std::array<scene::View, 6> views;
    std::array<std::vector<Rgba>, 6> colors;

    /// The pixel that a direction (world space, any length but 0) meets; of two views that meet at
    /// an edge the first.
    const Rgba& seen(const dvec3& direction) const;
};

/// The eye-space direction that position (s, t) of a sphere map stands for; beyond the rim, that of
/// the rim: straight ahead.
dvec3 direction_of(double s, double t);

/// size x size texels of 16 bits, each the mean of 4 x 4 positions in it, to nearest. `color_bits`
/// of the picture.
TextureRef sphere_map(std::string name, const CubePicture& around, const dmat4& eye_from_world,
                      int size, int color_bits);

}  // namespace gw::multipass
