#include "multipass/shadow/topology.h"

#include "scene/geometry/weld.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gw::multipass {
namespace {

auto key(const vec3& p) { return std::tuple(p.x, p.y, p.z); }

/// By vertex: the index of its point; points in order of their coordinates.
std::vector<std::uint32_t> number_points(const std::vector<vec3>& positions,
                                         std::vector<vec3>& points) {
    const std::vector<std::uint32_t> first = scene::weld(positions);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < first.size(); ++i)
        if (first[i] == i) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return key(positions[a]) < key(positions[b]);
    });
    std::vector<std::uint32_t> point_of(positions.size());
    for (const std::uint32_t vertex : order) {
        point_of[vertex] = static_cast<std::uint32_t>(points.size());
        points.push_back(positions[vertex]);
    }
    for (std::size_t i = 0; i < first.size(); ++i) point_of[i] = point_of[first[i]];
    return point_of;
}

/// A side of a triangle before the edges have numbers.
struct Use {
    std::uint32_t from = 0, to = 0;  ///< from < to
    std::uint32_t triangle = 0, side = 0;
    bool forward = true;
};

template <class Visit>
void for_each_use(const Topology& t, const Visit& visit) {
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t.triangles[i][k], b = t.triangles[i][(k + 1) % 3];
            visit(Use{std::min(a, b), std::max(a, b), i, k, a < b});
        }
}

/// In the order of their edges, then of the triangles. Few have one `from`: these only are sorted.
std::vector<Use> uses_of(const Topology& t) {
    std::vector<std::uint32_t> first(t.points.size() + 1, 0);
    for_each_use(t, [&](const Use& use) { ++first[use.from + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Use> uses(t.triangles.size() * 3);
    std::vector<std::uint32_t> next = first;
    for_each_use(t, [&](const Use& use) { uses[next[use.from]++] = use; });
    for (std::size_t from = 0; from < t.points.size(); ++from)
        std::sort(uses.begin() + first[from], uses.begin() + first[from + 1],
                  [](const Use& a, const Use& b) {
                      return std::tie(a.to, a.triangle, a.side) <
                             std::tie(b.to, b.triangle, b.side);
                  });
    return uses;
}

void number_edges(Topology& t) {
    t.sides.resize(t.triangles.size());
    int balance = 0;
    for (const Use& use : uses_of(t)) {
        if (t.edges.empty() || t.edges.back().from != use.from || t.edges.back().to != use.to) {
            t.closed = t.closed && balance == 0;
            balance = 0;
            t.edges.push_back({use.from, use.to});
        }
        balance += use.forward ? 1 : -1;
        t.sides[use.triangle][use.side] = {static_cast<std::uint32_t>(t.edges.size() - 1),
                                           use.forward};
    }
    t.closed = t.closed && balance == 0;
}

}  // namespace

Topology topology(const Mesh& mesh) {
    Topology t;
    if (mesh.kind() != MeshKind::Triangles) return t;
    const std::vector<std::uint32_t> point_of = number_points(mesh.data().positions, t.points);
    for (const Triangle& triangle : mesh.triangles()) {
        const std::array<std::uint32_t, 3> p{point_of[triangle.vertex[0]],
                                             point_of[triangle.vertex[1]],
                                             point_of[triangle.vertex[2]]};
        if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) t.triangles.push_back(p);
    }
    number_edges(t);
    return t;
}

}  // namespace gw::multipass
