#include "scene/geometry/divide.h"

#include <numeric>
#include <span>

namespace gw::scene {
namespace {

using Corners = std::span<const std::uint32_t>;

/// Weights of a quad's four corners, in units of 1 / (pieces * pieces).
using CornerWeights = std::array<double, 4>;

// On a side only two terms are not 0, so its other face, which may take the corners in another
// order, adds the same.
template <class Vector>
void add_point(std::vector<Vector>& values, Corners quad, const CornerWeights& w, double whole) {
    if (values.empty()) return;
    glm::vec<Vector::length(), double> v[4];
    for (std::size_t k = 0; k < 4; ++k)
        v[k] = glm::vec<Vector::length(), double>(values[quad[k]]) * w[k];
    values.push_back(Vector(((v[0] + v[1]) + (v[2] + v[3])) / whole));
}

class Divider {
public:
    Divider(MeshData& mesh, int pieces) : mesh_(mesh), pieces_(pieces) {}

    void add_divided(Corners quad) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        for (int j = 0; j <= pieces_; ++j)
            for (int i = 0; i <= pieces_; ++i) add_vertex(quad, i, j);
        const auto row = static_cast<std::uint32_t>(pieces_ + 1);
        for (std::uint32_t j = 0; j + 1 < row; ++j)
            for (std::uint32_t i = 0; i + 1 < row; ++i) {
                const std::uint32_t a = first + j * row + i;
                add_whole(std::array{a, a + 1, a + row + 1, a + row});
            }
    }

    void add_whole(Corners face) {
        indices.insert(indices.end(), face.begin(), face.end());
        if (mesh_.primitive == Primitive::Polygons)
            sizes.push_back(static_cast<std::uint32_t>(face.size()));
    }

    std::vector<std::uint32_t> indices, sizes;

private:
    void add_vertex(Corners quad, int i, int j) {
        const double u = i, v = j, n = pieces_;
        const CornerWeights w{(n - u) * (n - v), u * (n - v), u * v, (n - u) * v};
        add_point(mesh_.positions, quad, w, n * n);
        add_point(mesh_.normals, quad, w, n * n);
        add_point(mesh_.texcoords, quad, w, n * n);
        add_point(mesh_.colors, quad, w, n * n);
    }

    MeshData& mesh_;
    int pieces_;
};

void number_all(MeshData& mesh) {
    mesh.indices.resize(mesh.positions.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

}  // namespace

double divided_triangles(const MeshData& mesh, int pieces) {
    const double each = 2.0 * pieces * pieces;
    const std::size_t corners = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
    if (mesh.primitive == Primitive::Quads) return double(corners / 4) * each;
    if (mesh.primitive != Primitive::Polygons) return double(corners);
    if (mesh.polygon_sizes.empty()) return corners == 4 ? each : double(corners);
    double sum = 0;
    for (const std::uint32_t size : mesh.polygon_sizes) sum += size == 4 ? each : size - 2.0;
    return sum;
}

MeshData divide(MeshData mesh, int pieces) {
    const bool quads = mesh.primitive == Primitive::Quads;
    if (pieces == 1 || !(quads || mesh.primitive == Primitive::Polygons)) return mesh;
    if (mesh.indices.empty()) number_all(mesh);
    if (!quads && mesh.polygon_sizes.empty())
        mesh.polygon_sizes = {static_cast<std::uint32_t>(mesh.indices.size())};

    const std::vector<std::uint32_t> corners = std::move(mesh.indices);
    Divider divider(mesh, pieces);
    std::size_t face = 0;
    for (std::size_t first = 0; first < corners.size(); ++face) {
        const std::size_t size = quads ? 4 : mesh.polygon_sizes[face];
        const Corners whole(&corners[first], size);
        if (size == 4)
            divider.add_divided(whole);
        else
            divider.add_whole(whole);
        first += size;
    }
    mesh.indices = std::move(divider.indices);
    mesh.polygon_sizes = std::move(divider.sizes);
    return mesh;
}

}  // namespace gw::scene
