// Geometry sets that outlive their list: which are found again, and that a frame drawn with them has the bits
// of one drawn without (each list of the workbench is its own).
#include "gw/fast/kept_geometry.h"
#include "tests/gw/workbench.h"

namespace gw::fast {
namespace {

MeshRef triangle(float x = 0) {
    return make_mesh(
        {.primitive = Primitive::Triangles, .positions = {{x, 0, 1}, {x + 40, 0, 9}, {x + 40, 50, 5}}});
}

/// Sets with one element, as a plan has it before anything is made.
std::deque<GeometrySet> wanted(const MeshRef& mesh) {
    std::deque<GeometrySet> sets(1);
    sets[0].key.mesh = mesh;
    return sets;
}

/// Keeps a set of `mesh` with one primitive, changes what a later list wants, and says whether it got that
/// set.
bool served(const MeshRef& mesh, void (*made)(GeometrySet&), void (*change)(GeometrySet&)) {
    KeptGeometry kept;
    std::deque<GeometrySet> first = wanted(mesh);
    first[0].made = true;
    first[0].primitives.resize(1);
    made(first[0]);
    kept.keep(std::move(first));
    std::deque<GeometrySet> later = wanted(mesh);
    change(later[0]);
    kept.give(later);
    EXPECT_EQ(later[0].made, later[0].primitives.size() == 1);
    EXPECT_EQ(later[0].key.mesh, mesh);
    return later[0].made;
}
void as_it_is(GeometrySet&) {}

TEST(KeptGeometry, ServesTheSameKey) { EXPECT_TRUE(served(triangle(), as_it_is, as_it_is)); }
TEST(KeptGeometry, AnotherKeyIsMadeAnew) {
    EXPECT_FALSE(served(triangle(), as_it_is, [](GeometrySet& s) { s.key.projection[3][0] = 1e-12; }));
    EXPECT_FALSE(served(triangle(), as_it_is, [](GeometrySet& s) { s.key.cull.enable = true; }));
}
TEST(KeptGeometry, ListsOfVerticesAreMadeWhereTheyAreMissing) {
    const auto lists = [](GeometrySet& s) { s.lists_used = true; };
    EXPECT_FALSE(served(triangle(), as_it_is, lists));
    EXPECT_TRUE(served(triangle(), lists, lists));
    EXPECT_TRUE(served(triangle(), lists, as_it_is));
}
TEST(KeptGeometry, BinsServeJitterThatTheyWereMadeFor) {
    const auto wide = [](GeometrySet& s) { s.jitter_low = {-3, -2}, s.jitter_high = {5, 4}; };
    const auto narrow = [](GeometrySet& s) { s.jitter_low = {-3, 0}, s.jitter_high = {0, 4}; };
    EXPECT_TRUE(served(triangle(), wide, narrow));
    EXPECT_FALSE(served(triangle(), narrow, wide));
    EXPECT_FALSE(served(triangle(), narrow, [](GeometrySet& s) { s.jitter_low = {-3, -1}; }));
    EXPECT_FALSE(served(triangle(), narrow, [](GeometrySet& s) { s.jitter_high = {1, 4}; }));
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

/// The fast machine draws each list with what it kept of the last, the reference machine does not.
TEST(KeptGeometry, FramesHaveTheSameBits) {
    test::Workbench bench(vgx(), 128, 128);
    const Draw draw{.mesh = triangle(24.4f)};  // to the side of a tile; with jitter, over it
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
    EXPECT_GT(bench.take_counters().fragments, 5000u);
}

/// A new mesh mostly stands where the last one stood.
TEST(KeptGeometry, AMeshAtTheSameAddressIsAnother) {
    test::Workbench bench;
    for (int i = 0; i < 20; ++i) {
        bench.clear();
        bench.draw(Draw{.mesh = triangle(float(i))});
        bench.planes();
    }
}

}  // namespace
}  // namespace gw::fast
