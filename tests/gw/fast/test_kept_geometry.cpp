// Geometry sets that outlive their list: which of them later lists use, and that a frame drawn with
// them has the same bits as a frame drawn without.
#include "gw/fast/plan/kept_geometry.h"
#include "tests/gw/workbench.h"

namespace gw::fast {
namespace {

MeshRef triangle(float x = 0) {
    return make_mesh({.primitive = Primitive::Triangles,
                      .positions = {{x, 0, 1}, {x + 40, 0, 9}, {x + 40, 50, 5}}});
}

/// One set as a plan has it before its vertices are computed.
std::deque<GeometrySet> wanted(const MeshRef& mesh) {
    std::deque<GeometrySet> sets(1);
    sets[0].key.mesh = mesh;
    return sets;
}

/// Keeps a set of `mesh`. Returns whether a later list whose key is changed gets this set.
bool served(const MeshRef& mesh, void (*change)(GeometryKey&)) {
    KeptGeometry kept;
    std::deque<GeometrySet> first = wanted(mesh);
    first[0].made = true;
    first[0].primitives.resize(1);
    kept.keep(std::move(first));
    std::deque<GeometrySet> later = wanted(mesh);
    change(later[0].key);
    later[0].lists_used = true;
    later[0].jitter.include({3, -4});
    kept.give(later);
    EXPECT_EQ(later[0].made, later[0].primitives.size() == 1);
    EXPECT_EQ(later[0].key.mesh, mesh);
    EXPECT_TRUE(later[0].lists_used && later[0].jitter.high.x == 3 && later[0].jitter.low.y == -4);
    return later[0].made;
}

TEST(KeptGeometry, ServesTheSameKey) {
    EXPECT_TRUE(served(triangle(), [](GeometryKey&) {}));
    EXPECT_FALSE(served(triangle(), [](GeometryKey& k) { k.projection[3][0] = 1e-12; }));
    EXPECT_FALSE(served(triangle(), [](GeometryKey& k) { k.cull.enable = true; }));
}
TEST(KeptGeometry, DoesNotKeepAMeshAlive) {
    KeptGeometry kept;
    MeshRef mesh = triangle();
    const std::weak_ptr<const Mesh> watched = mesh;
    std::deque<GeometrySet> first = wanted(mesh);
    first[0].made = true;
    kept.keep(std::move(first));
    mesh.reset();
    EXPECT_TRUE(watched.expired());
}
TEST(KeptGeometry, ASegmentWithoutGeometryChangesNothing) {
    KeptGeometry kept;
    const MeshRef mesh = triangle();
    std::deque<GeometrySet> first = wanted(mesh);
    first[0].made = true;
    kept.keep(std::move(first));
    kept.keep({});
    std::deque<GeometrySet> later = wanted(mesh);
    kept.give(later);
    EXPECT_TRUE(later[0].made);
}

/// The fast machine draws each list with sets of the last one, the reference machine does not.
TEST(KeptGeometry, FramesHaveTheSameBits) {
    test::Workbench bench(vgx(), 128, 128);
    const Draw draw{.mesh = triangle(24.2f)};  // up to the side of a tile; with jitter, across it
    bench.clear();
    bench.draw(draw);
    bench.state.color_source = ColorSource::PolygonId;
    bench.state.depth = {true, DepthFunc::LEqual, true};
    bench.draw(draw);
    bench.state.color_source = ColorSource::Lighting;
    bench.state.lighting.model_ambient = vec4(0.7f);
    bench.draw(draw);
    bench.state.jitter = {1, -1};
    bench.draw(draw);
    bench.state.jitter = {7, -1};
    bench.draw(draw);
    bench.state.polygon_mode = PolygonMode::Line;
    bench.draw(draw);
    EXPECT_GT(bench.take_counters().fragments, 4000u);
}

/// A new mesh may have the address of a deleted one.
TEST(KeptGeometry, AMeshAtTheSameAddressIsAnother) {
    const MeshRef memory = triangle();
    const auto born = [&] { return MeshRef(memory.get(), [](const Mesh*) {}); };
    KeptGeometry kept;
    MeshRef mesh = born();
    std::deque<GeometrySet> first = wanted(mesh);
    first[0].made = true;
    kept.keep(std::move(first));
    mesh = born();
    std::deque<GeometrySet> later = wanted(mesh);
    kept.give(later);
    EXPECT_FALSE(later[0].made);
}

}  // namespace
}  // namespace gw::fast
