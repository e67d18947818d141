// The end of a shadow volume (shadow_volume.h): its points move away from the light. The far cap
// must lie beyond everything that may be in shadow. It should not lie much farther: faces drawn
// there cost time and show nothing. Does not make the volume.
//
// A point moves to the place at which its path from the light leaves the scene's bounds. A triangle
// of the far cap is beyond the scene if its three corners are beyond the same wall of the bounds.
// Until then the corner with the shortest next step moves on, beyond its next wall, and in the end
// by the light's reach, which is more than the whole scene.
#pragma once

#include "multipass/shadow/topology.h"
#include "scene/scene.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::multipass {

/// A light and the scene's bounds in an object's own coordinates.
struct LightInObject {
    bool directional = false;
    dvec3 position{0};  ///< of a directional light: its direction, length 1
    /// Everything that may be in shadow is nearer than this: to the light, or along its direction
    /// from the origin.
    double reach = 0;
    /// The six walls of the scene's bounds: dot(xyz, p) + w is the distance of p beyond the wall,
    /// world units. All 0: unknown, points move by `reach` alone.
    std::array<dvec4, 6> walls{};
    double margin = 0;  ///< points move this far beyond a wall, world units
};

LightInObject light_in_object(const scene::Light& light, const dmat4& world_from_object,
                              const scene::Bounds& bounds);

/// The walls that p lies beyond, one bit each.
unsigned walls_before(const LightInObject& light, const dvec3& p);

/// Whether the light sees a and b more than 60 degrees apart: a far cap between them would cut
/// through the scene.
bool is_wide(const LightInObject& light, const dvec3& a, const dvec3& b);

/// p, moved away from the light by its reach.
vec3 moved_by_reach(const LightInObject& light, const dvec3& p);

/// The sets of walls of the far cap's triangles. Bit s is set if a triangle has its corners beyond
/// exactly the walls s (again one bit each). Bit 0: its corners moved by the light's reach.
using WallsOfCap = std::bitset<64>;

/// The far cap of a set of triangles.
struct FarCap {
    std::vector<vec3> moved;  ///< by point of the topology: the place of a corner; others are 0
    WallsOfCap walls;
};
/// `part`, by triangle of the topology: not 0 for those of the cap.
FarCap far_cap(const Topology& topology, const LightInObject& light, std::span<const int> part);

}  // namespace gw::multipass
