// Geometry sets that outlive their list: which are found again, and that a frame drawn with them
// has the bits of one drawn without them.
#include "gw/fast/plan/kept_geometry.h"
#include "tests/gw/workbench.h"

namespace gw::fast {
namespace {

MeshRef triangle(float x = 0) {
    return make_mesh({.primitive = Primitive::Triangles,
                      .positions = {{x, 0, 1}, {x + 40, 0, 9}, {x + 40, 50, 5}}});
}

/// The sets of a segment with one part.
struct Asked {
    GeometrySet* found;  ///< null: made anew
    GeometrySet* set;
};
Asked ask(KeptGeometry& kept, const MeshRef& mesh, const GeometryState& state = {},
          const dmat4& eye_from_object = dmat4(1)) {
    const PartKey part{&mesh, &eye_from_object};
    kept.begin_segment();
    GeometrySet* const found = kept.find(1, state, {&part, 1});
    GeometrySet* const set = found ? found : &kept.make(1, state, {&part, 1});
    set->lists_used = true;
    set->jitter.include({3, -4});
    kept.end_segment();
    return {found, set};
}

TEST(KeptGeometry, FindsTheSameStateAndParts) {
    KeptGeometry kept;
    const MeshRef mesh = triangle();
    GeometrySet* const set = ask(kept, mesh).set;
    EXPECT_EQ(ask(kept, mesh).found, set);
    GeometryState moved, culled;
    moved.projection[3][0] = 1e-12;
    culled.cull.enable = true;
    EXPECT_FALSE(ask(kept, mesh, moved).found);
    EXPECT_FALSE(ask(kept, mesh, culled).found);
    EXPECT_FALSE(ask(kept, mesh, culled, dmat4(2)).found);
    EXPECT_FALSE(ask(kept, triangle(), culled, dmat4(2)).found);
}
TEST(KeptGeometry, FoundSetsForgetWhatTheirLastDrawsWanted) {
    KeptGeometry kept;
    const MeshRef mesh = triangle();
    ask(kept, mesh);
    const dmat4 identity{1};
    const PartKey part{&mesh, &identity};
    kept.begin_segment();
    const GeometrySet* const set = kept.find(1, {}, {&part, 1});
    ASSERT_TRUE(set);
    EXPECT_TRUE(!set->lists_used && set->jitter.high.x == 0 && set->jitter.low.y == 0);
}
TEST(KeptGeometry, DoesNotKeepAMeshAlive) {
    KeptGeometry kept;
    MeshRef mesh = triangle();
    const std::weak_ptr<const Mesh> watched = mesh;
    ask(kept, mesh);
    mesh.reset();
    EXPECT_TRUE(watched.expired());
}
TEST(KeptGeometry, DropsSetsThatFourSegmentsDidNotUse) {
    KeptGeometry kept;
    const MeshRef mesh = triangle();
    ask(kept, mesh);
    const auto other_segments = [&](int count) {
        for (int i = 0; i < count; ++i) {
            kept.begin_segment();
            kept.end_segment();
        }
    };
    other_segments(4);
    EXPECT_EQ(kept.size(), 1u);
    other_segments(20);
    EXPECT_EQ(kept.size(), 0u);
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

/// A new mesh may have the address of one that is gone.
TEST(KeptGeometry, AMeshAtTheSameAddressIsAnother) {
    const auto memory = std::make_shared<Mesh>(*triangle());
    KeptGeometry kept;
    ask(kept, memory);
    EXPECT_TRUE(ask(kept, memory).found);
    *memory = *triangle();
    EXPECT_FALSE(ask(kept, memory).found);
}

}  // namespace
}  // namespace gw::fast
