// Welding by sorting: no hash tables, so the order is the same everywhere.
#include "multipass/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gw::multipass {
namespace {

auto key(const vec3& p) { return std::tuple(p.x, p.y, p.z); }

/// By vertex: the index of its point; points in order of their coordinates.
std::vector<std::uint32_t> weld(const std::vector<vec3>& positions, std::vector<vec3>& points) {
    std::vector<std::uint32_t> order(positions.size()), point_of(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(positions[a]) < key(positions[b]); });
    for (const std::uint32_t vertex : order) {
        if (points.empty() || points.back() != positions[vertex]) points.push_back(positions[vertex]);
        point_of[vertex] = static_cast<std::uint32_t>(points.size() - 1);
    }
    return point_of;
}

/// A side of a triangle before the edges have numbers.
struct Use {
    std::uint32_t from, to;  ///< from < to
    std::uint32_t triangle, side;
    bool forward;
};

std::vector<Use> uses_of(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<Use> uses;
    uses.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            uses.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
        }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::tie(a.from, a.to, a.triangle, a.side) < std::tie(b.from, b.to, b.triangle, b.side);
    });
    return uses;
}

void number_edges(Topology& t) {
    t.sides.resize(t.triangles.size());
    int balance = 0;
    for (const Use& use : uses_of(t.triangles)) {
        if (t.edges.empty() || t.edges.back().from != use.from || t.edges.back().to != use.to) {
            t.closed = t.closed && balance == 0;
            balance = 0;
            t.edges.push_back({use.from, use.to});
        }
        balance += use.forward ? 1 : -1;
        t.sides[use.triangle][use.side] = {static_cast<std::uint32_t>(t.edges.size() - 1), use.forward};
    }
    t.closed = t.closed && balance == 0;
}

}  // namespace

Topology topology(const Mesh& mesh) {
    Topology t;
    if (mesh.kind() != MeshKind::Triangles) return t;
    const std::vector<std::uint32_t> point_of = weld(mesh.data().positions, t.points);
    for (const Triangle& triangle : mesh.triangles()) {
        const std::array<std::uint32_t, 3> p{point_of[triangle.vertex[0]], point_of[triangle.vertex[1]],
                                             point_of[triangle.vertex[2]]};
        if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) t.triangles.push_back(p);
    }
    number_edges(t);
    return t;
}

}  // namespace gw::multipass
