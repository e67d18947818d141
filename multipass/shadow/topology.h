// A mesh as a surface, for shadow volumes: welded points, edges, and the triangles along them. Does
// not know lights.
#pragma once

#include "gw/mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace gw::multipass {

/// The triangles of a mesh over welded points, without those that have two equal corners.
struct Topology {
    struct Edge {
        std::uint32_t from = 0, to = 0;  ///< from < to
    };
    struct Side {
        std::uint32_t edge = 0;
        bool forward = true;  ///< the triangle runs along it from `from` to `to`
    };
    std::vector<vec3> points;
    /// into points, orientation as in the mesh
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<Side, 3>> sides;  ///< by triangle: 0 to 1, 1 to 2, 2 to 0
    std::vector<Edge> edges;
    /// At every edge as many triangles run forward as backward: the surface has two sides and no
    /// border.
    bool closed = true;
};

/// Parts that have one mesh share its topology.
using TopologyRef = std::shared_ptr<const Topology>;

/// Meshes of lines or points have no triangles.
Topology topology(const Mesh& mesh);

}  // namespace gw::multipass
