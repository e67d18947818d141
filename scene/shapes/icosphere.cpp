#include "gw/base/elementary.h"
#include "scene/shapes/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gw::scene {
namespace {

using NetTriangle = std::array<std::uint32_t, 3>;

// Points on the unit sphere and the triangles between them.
struct Net {
    std::vector<dvec3> points;
    std::vector<NetTriangle> triangles;
};

// A pole, two rings of five, a pole.
Net icosahedron() {
    Net net;
    const double y = std::sqrt(0.2), r = 2 * y;
    net.points.push_back({0, 1, 0});
    for (int i = 0; i < 10; ++i) {
        const double degrees = 36 * i;  // even: upper ring, odd: lower ring
        net.points.push_back(
            {r * sin_degrees(degrees), i % 2 == 0 ? y : -y, r * cos_degrees(degrees)});
    }
    net.points.push_back({0, -1, 0});
    const auto ring = [](std::uint32_t i) { return 1 + i % 10; };
    for (std::uint32_t i = 0; i < 10; i += 2) {
        net.triangles.push_back({ring(i), ring(i + 2), 0});
        net.triangles.push_back({ring(i), ring(i + 1), ring(i + 2)});
        net.triangles.push_back({ring(i + 1), ring(i + 3), ring(i + 2)});
        net.triangles.push_back({ring(i + 3), ring(i + 1), 11});
    }
    return net;
}

// Each triangle becomes four; the middle of a side is one point for both its triangles.
Net divide(Net net) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(net.points.size()));
        if (is_new) net.points.push_back(glm::normalize(net.points[a] + net.points[b]));
        return found->second;
    };
    std::vector<NetTriangle> triangles;
    for (const auto& [a, b, c] : net.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    net.triangles = std::move(triangles);
    return net;
}

bool is_pole(const dvec3& p) { return p.x == 0 && p.z == 0; }

double turn(const dvec3& p) {
    const double s = atan2(p.x, p.z) / (2 * pi);
    return s < 0 ? s + 1 : s;
}

// s of a triangle's corners. One turn is added to corners beyond the seam; a pole lies between the
// two others.
std::array<double, 3> corner_turns(const std::array<dvec3, 3>& p) {
    std::array<double, 3> s{turn(p[0]), turn(p[1]), turn(p[2])};
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (!is_pole(p[k])) most = std::max(most, s[k]);
    for (std::size_t k = 0; k < 3; ++k)
        if (!is_pole(p[k]) && most - s[k] > 0.5) s[k] += 1;
    for (std::size_t k = 0; k < 3; ++k)
        if (is_pole(p[k])) s[k] = (s[(k + 1) % 3] + s[(k + 2) % 3]) / 2;
    return s;
}

double height(const dvec3& p) { return 0.5 + atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z)) / pi; }

}  // namespace

MeshData make_icosphere(double radius, int divisions) {
    Net net = icosahedron();
    for (int i = 0; i < divisions; ++i) net = divide(std::move(net));
    MeshData mesh;
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> vertices;  // by point and s
    for (const NetTriangle& corners : net.triangles) {
        const auto s =
            corner_turns({net.points[corners[0]], net.points[corners[1]], net.points[corners[2]]});
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3& p = net.points[corners[k]];
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [found, is_new] = vertices.try_emplace({corners[k], s[k]}, next);
            mesh.indices.push_back(found->second);
            if (!is_new) continue;
            mesh.positions.emplace_back(radius * p);
            mesh.normals.emplace_back(p);
            mesh.texcoords.emplace_back(s[k], height(p));
        }
    }
    return mesh;
}

}  // namespace gw::scene
