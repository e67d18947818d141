#include "apps/study/growth_scenes.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gw::study {
namespace {

/// Random numbers that are the same everywhere.
class Random {
public:
    double operator()(double low, double high) {
        return low + (high - low) * (double(engine_()) / 4294967295.0);
    }

private:
    std::mt19937 engine_{1};
};

scene::Scene scene_of(MeshData data, const dvec3& eye, double degrees) {
    scene::Scene scene;
    scene.materials.push_back({});
    scene.objects.push_back({.name = "polygons", .mesh = make_mesh(std::move(data))});
    const double angle = degrees * 3.14159265358979323846 / 180, c = gw::cos(angle),
                 s = gw::sin(angle);
    scene.camera =
        scene::Camera{.eye = {c * eye.x + s * eye.z, eye.y, c * eye.z - s * eye.x}, .fov = 40};
    return scene;
}

}  // namespace

scene::Scene triangle_soup(int count, double depth, double degrees) {
    Random random;
    // At depth 4, 256 triangles put 4 over each pixel that shows one. At larger depths, large parts
    // of them are outside the window.
    const double size = 6 * std::sqrt(depth / count);
    MeshData data;
    for (int i = 0; i < count; ++i) {
        const double z = random(-1.6, 1.6), y = random(-1.2, 1.2), x = random(-1.6, 1.6);
        for (int k = 0; k < 3; ++k) {
            const double w = random(-1, 1), v = random(-1, 1), u = random(-1, 1);
            data.positions.push_back(vec3(dvec3(x, y, z) + size * dvec3(u, v, w)));
        }
    }
    return scene_of(std::move(data), {0, 0, 6}, degrees);
}

scene::Scene hill_grid(int count, double height, double degrees) {
    const int n = std::max(int(std::sqrt(double(count)) + 0.5), 1);
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k) {
            const double x = 4.0 * i / n - 2, z = 4.0 * k / n - 2;
            data.positions.push_back(vec3(
                dvec3(x, 0.25 * gw::sin(5 * x + 1) * gw::cos(4 * z) + 0.1 * gw::sin(9 * z), z)));
        }
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            for (const int corner : {0, 1, n + 2, n + 1})
                data.indices.push_back(std::uint32_t(i * (n + 1) + k + corner));
    return scene_of(std::move(data), {1, height, 5}, degrees);
}

}  // namespace gw::study
