#include "gw/mesh/decompose.h"

#include "gw/mesh/triangulate.h"

#include <algorithm>

namespace gw {
namespace {

using Corners = std::span<const std::uint32_t>;

/// The sides from each vertex to the next that are edges of the outline: bit k of a triangle.
std::uint8_t flagged_edges(const MeshData& data, const std::array<std::uint32_t, 3>& vertex,
                           std::uint8_t edges) {
    if (data.edge_flags.empty()) return edges;
    for (std::size_t k = 0; k < 3; ++k)
        if (data.edge_flags[vertex[k]] == 0) edges = std::uint8_t(edges & ~(1u << k));
    return edges;
}

std::vector<Triangle> separate_triangles(const MeshData& data, Corners c) {
    std::vector<Triangle> triangles;
    triangles.reserve(c.size() / 3);
    for (std::uint32_t i = 0; i < c.size() / 3; ++i) {
        const std::array<std::uint32_t, 3> vertex{c[3 * i], c[3 * i + 1], c[3 * i + 2]};
        triangles.push_back({vertex, c[3 * i + 2], i, flagged_edges(data, vertex, 7)});
    }
    return triangles;
}

// [GL11] 2.6.1: every second triangle swaps its first two vertices, so that all turn as the first
// does.
std::vector<Triangle> strip(Corners c) {
    std::vector<Triangle> triangles;
    triangles.reserve(c.size());
    for (std::uint32_t i = 0; i + 2 < c.size(); ++i) {
        const bool odd = i % 2 != 0;
        triangles.push_back({{c[i + odd], c[i + !odd], c[i + 2]}, c[i + 2], i});
    }
    return triangles;
}

std::vector<Triangle> fan(Corners c) {
    std::vector<Triangle> triangles;
    triangles.reserve(c.size());
    for (std::uint32_t i = 0; i + 2 < c.size(); ++i)
        triangles.push_back({{c[0], c[i + 1], c[i + 2]}, c[i + 2], i});
    return triangles;
}

/// A quad that becomes a fan.
bool add_fan(std::vector<Triangle>& triangles, const MeshData& data, Corners c,
             std::uint32_t provoking, std::uint32_t polygon) {
    const std::array<vec3, 4> positions{data.positions[c[0]], data.positions[c[1]],
                                        data.positions[c[2]], data.positions[c[3]]};
    if (!becomes_fan(positions)) return false;
    for (std::size_t i = 1; i < 3; ++i) {
        const std::array<std::uint32_t, 3> vertex{c[0], c[i], c[i + 1]};
        triangles.push_back(
            {vertex, provoking, polygon, flagged_edges(data, vertex, fan_edges(i, 4))});
    }
    return true;
}

void add_polygon(std::vector<Triangle>& triangles, const MeshData& data, Corners c,
                 std::uint32_t provoking, std::uint32_t polygon) {
    if (c.size() == 3) {
        const std::array<std::uint32_t, 3> vertex{c[0], c[1], c[2]};
        triangles.push_back({vertex, provoking, polygon, flagged_edges(data, vertex, 7)});
        return;
    }
    if (c.size() == 4 && add_fan(triangles, data, c, provoking, polygon)) return;
    std::vector<vec3> positions;
    positions.reserve(c.size());
    for (const std::uint32_t vertex : c) positions.push_back(data.positions[vertex]);
    for (const auto& [corner, edges] : triangulate(std::span<const vec3>(positions))) {
        const std::array<std::uint32_t, 3> vertex{c[corner[0]], c[corner[1]], c[corner[2]]};
        triangles.push_back({vertex, provoking, polygon, flagged_edges(data, vertex, edges)});
    }
}

// [GL11] table 2.12: a quad has the colour of its last vertex, a polygon that of its first.
std::vector<Triangle> quads(const MeshData& data, Corners c) {
    std::vector<Triangle> triangles;
    triangles.reserve(c.size() / 2);
    for (std::uint32_t i = 0; i < c.size() / 4; ++i)
        add_polygon(triangles, data, c.subspan(std::size_t{4} * i, 4), c[4 * i + 3], i);
    return triangles;
}

std::vector<Triangle> polygons(const MeshData& data, Corners c) {
    std::vector<Triangle> triangles;
    triangles.reserve(c.size() - std::min(c.size(), 2 * data.polygon_sizes.size()));
    if (data.polygon_sizes.empty() && !c.empty()) add_polygon(triangles, data, c, c[0], 0);
    std::size_t first = 0;
    for (std::uint32_t i = 0; i < data.polygon_sizes.size(); ++i) {
        add_polygon(triangles, data, c.subspan(first, data.polygon_sizes[i]), c[first], i);
        first += data.polygon_sizes[i];
    }
    return triangles;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> decompose_lines(Primitive primitive, Corners c) {
    const std::size_t step = primitive == Primitive::LineStrip ? 1 : 2;
    std::vector<std::array<std::uint32_t, 2>> lines;
    for (std::size_t i = 0; i + 1 < c.size(); i += step) lines.push_back({c[i], c[i + 1]});
    return lines;
}

std::vector<Triangle> decompose_triangles(const MeshData& data, Corners c) {
    switch (data.primitive) {
        case Primitive::Triangles: return separate_triangles(data, c);
        case Primitive::TriangleStrip: return strip(c);
        case Primitive::TriangleFan: return fan(c);
        case Primitive::Quads: return quads(data, c);
        case Primitive::Polygons: return polygons(data, c);
        case Primitive::Points:
        case Primitive::Lines:
        case Primitive::LineStrip: break;
    }
    return {};
}

}  // namespace gw
