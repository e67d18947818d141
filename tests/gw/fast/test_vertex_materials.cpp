// Materials by vertex, whose lighting the fast machine computes in vectors if they have one exponent.
#include "conformance/generate/draw.h"
#include "tests/gw/workbench.h"

#include <memory>

namespace gw::test {
namespace {

constexpr int side = 64;

/// Triangles in the window, each vertex with one of `materials`.
MeshRef any_mesh(conformance::Random& r, std::vector<FaceMaterials> materials) {
    MeshData data{.primitive = Primitive::Triangles};
    for (int i = 0, n = 3 * r.between(1, 16); i < n; ++i) {
        data.positions.push_back(
            {float(r.below(8 * side)) / 8, float(r.below(8 * side)) / 8, float(r.below(1 << 22))});
        data.normals.push_back({float(r.between(-8, 8)) / 8, float(r.between(-8, 8)) / 8, 1});
        data.material_indices.push_back(std::uint32_t(r.below(int(materials.size()))));
    }
    data.materials = std::move(materials);
    return make_mesh(std::move(data));
}

TEST(VertexMaterials, HaveTheBitsOfTheReference) {
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE(seed);
        conformance::Random r(conformance::seed_of("vertex materials", seed));
        std::vector<FaceMaterials> materials;
        for (int i = 0; i < 4; ++i)
            materials.push_back({conformance::any_material(r), conformance::any_material(r)});
        if (r.chance(70))
            for (FaceMaterials& m : materials) m.front.Ns = materials[0].front.Ns;
        if (r.chance(70))
            for (FaceMaterials& m : materials) m.back.Ns = materials[0].back.Ns;
        Workbench bench(opengl(), side, side);
        bench.state.color_source = ColorSource::Lighting;
        bench.state.lighting.two_side = r.chance(50);
        bench.state.lighting.local_viewer = r.chance(50);
        bench.state.normalize = r.chance(50);
        bench.draw({.mesh = any_mesh(r, std::move(materials)),
                    .lights = conformance::any_lights(r, 3, double(1 << 22))});
    }
}

}  // namespace
}  // namespace gw::test
