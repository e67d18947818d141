// Where a shadow volume ends: how far its points are moved away from the light, so that the far cap
// lies beyond everything that may be in shadow, and hardly farther: what is drawn there nobody
// sees. Serves shadow_volume.h.
//
// A point is moved to where its way from the light leaves the scene's bounds. A triangle of the far
// cap is beyond the scene where its three corners are beyond one and the same wall of the bounds;
// until they are, the corner with the least way to go is moved on to where it leaves by its next
// wall, at last to a distance that is more than the whole scene's.
#pragma once

#include "multipass/shadow/topology.h"
#include "scene/scene.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::multipass {

/// A light, and the scene's bounds, as an object's own coordinates see them.
struct LightInObject {
    bool directional = false;
    dvec3 position{0};  ///< or, where directional, the way the light travels (length 1)
    /// Everything that may be in shadow is nearer than this: to the light, or along its way from
    /// the origin.
    double reach = 0;
    /// The six walls of the scene's bounds: dot(xyz, p) + w is how far p lies beyond, world units.
    /// All 0: not known, points are moved by `reach` alone.
    std::array<dvec4, 6> walls{};
    double margin = 0;  ///< points are moved so far beyond a wall, world units
};

LightInObject light_in_object(const scene::Light& light, const dmat4& world_from_object,
                              const scene::Bounds& bounds);

/// The walls that p lies beyond, a bit each.
unsigned walls_before(const LightInObject& light, const dvec3& p);

/// Whether the light sees a and b under more than 60 degrees: a far cap between them would cut
/// through the scene.
bool is_wide(const LightInObject& light, const dvec3& a, const dvec3& b);

/// p moved away from the light by its reach.
vec3 moved_by_reach(const LightInObject& light, const dvec3& p);

/// Triangles of the far cap, by the walls that all corners are beyond: bit s is set where some
/// triangle's walls are s (a set of bits too). Bit 0: its corners are moved by the light's reach.
using WallsOfCap = std::bitset<64>;

/// Of the points that the triangles have as corners, where they are moved to.
struct FarCap {
    std::vector<vec3> moved;  ///< by point of the topology
    WallsOfCap walls;
};
/// Of some of the topology's triangles.
FarCap far_cap(const Topology& topology, const LightInObject& light, std::span<const int> part);

}  // namespace gw::multipass
