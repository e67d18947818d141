#include "scene/shapes/grid.h"

#include <glm/geometric.hpp>

namespace gw::scene {
namespace {

void add_triangle(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto same = [&](std::uint32_t i, std::uint32_t k) {
        return mesh.positions[i] == mesh.positions[k];
    };
    if (same(a, b) || same(b, c) || same(c, a)) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void add_vertex(MeshData& mesh, const GridVertex& vertex) {
    mesh.positions.emplace_back(vertex.position);
    mesh.normals.emplace_back(glm::normalize(vertex.normal));
    mesh.texcoords.emplace_back(vertex.texcoord);
}

}  // namespace

MeshData make_grid(int columns, int rows, const std::function<GridVertex(int column, int row)>& at,
                   Primitive primitive) {
    MeshData mesh{.primitive = primitive};
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) add_vertex(mesh, at(column, row));
    const auto index = [&](int column, int row) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = index(column, row), b = index(column + 1, row);
            const std::uint32_t c = index(column + 1, row + 1), d = index(column, row + 1);
            if (primitive == Primitive::Quads) {
                mesh.indices.insert(mesh.indices.end(), {a, b, c, d});
            } else {
                add_triangle(mesh, a, b, c);
                add_triangle(mesh, a, c, d);
            }
        }
    return mesh;
}

void append(MeshData& mesh, const MeshData& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.texcoords.insert(mesh.texcoords.end(), other.texcoords.begin(), other.texcoords.end());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

}  // namespace gw::scene
