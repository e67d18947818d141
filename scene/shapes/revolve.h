// Surfaces of revolution about the y axis. Does not know profiles: revolved.cpp and lathe.cpp do.
#pragma once

#include "gw/mesh.h"

#include <vector>

namespace gw::scene {

/// A point of the profile curve: (distance from the axis, height).
struct ProfilePoint {
    dvec2 position;
    dvec2 normal;  ///< to the right of the curve's direction, any length
    double t;      ///< texture coordinate along the curve
};

/// Turns a profile in steps of 360 / slices degrees. The curve runs so that outside is to its
/// right: bottom, up along the outside, down along the inside. s runs once round, from z, over x,
/// in steps of 1 / slices; at a point on the axis it lies between its triangle's two others.
MeshData revolve(const std::vector<ProfilePoint>& profile, int slices);

}  // namespace gw::scene
