// docs/manual/counters.md: the worked examples.
#include "tests/gw/workbench.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace gw {
namespace {

using test::Workbench;

std::vector<vec3> square(float z) { return {{8, 8, z}, {24, 8, z}, {24, 24, z}, {8, 24, z}}; }

// [R14.8]
TEST(ManualCounters, BytesByHand) {
    Workbench bench;
    bench.clear(all_planes, vec4(0), 0.5);
    EXPECT_EQ(bench.take_counters().bytes, 64u * 64 * (4 + 3 + 1 + 8));
    bench.state.depth.test = true;
    bench.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.draw(Primitive::Quads, square(16000000));
    Counters c = bench.take_counters();
    EXPECT_EQ(c.depth_killed, 256u);
    EXPECT_EQ(c.bytes, 1280u);
    bench.draw(Primitive::Quads, square(5));
    c = bench.take_counters();
    EXPECT_EQ(c.written, 256u);
    EXPECT_EQ(c.bytes, 4096u);
}

// [R14.2] [R14.4]
TEST(ManualCounters, PrimitivesByTheirFate) {
    Workbench bench;
    bench.state.cull.enable = true;
    bench.draw(Primitive::Triangles, {{8, 8, 0},
                                      {24, 8, 0},
                                      {24, 24, 0},  // drawn
                                      {8, 8, 0},
                                      {24, 24, 0},
                                      {24, 8, 0},  // culled
                                      {8, 8, 0},
                                      {24, 24, 0},
                                      {40, 40, 0},  // degenerate
                                      {8, 8, -5},
                                      {24, 8, -5},
                                      {24, 24, -5},  // rejected: before the near plane
                                      {8, 8, -100},
                                      {24, 8, 1000},
                                      {24, 24, 1000},  // clipped and drawn
                                      {900, 8, 0},
                                      {924, 8, 0},
                                      {924, 24, 0}});  // drawn, outside the window
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.draws, 1u);
    EXPECT_EQ(c.vertices, 18u);
    EXPECT_EQ(c.primitives, 6u);
    EXPECT_EQ(c.rejected, 1u);
    EXPECT_EQ(c.clipped, 1u);
    EXPECT_EQ(c.degenerate, 1u);
    EXPECT_EQ(c.culled, 1u);
    EXPECT_EQ(c.drawn, 3u);
}

// [R5.2] [R14.6]
TEST(ManualCounters, TexelsGoByTheMinificationFilter) {
    const std::pair<MinFilter, unsigned> lookups[] = {{MinFilter::Nearest, 1},
                                                      {MinFilter::Linear, 4},
                                                      {MinFilter::NearestMipmapNearest, 1},
                                                      {MinFilter::LinearMipmapNearest, 4},
                                                      {MinFilter::NearestMipmapLinear, 2},
                                                      {MinFilter::LinearMipmapLinear, 8}};
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads, square(0)))};
    draw.map.texture = make_texture8("white", 1, 1, std::vector<std::uint8_t>(4, 255));
    for (const auto& [filter, n] : lookups) {
        Workbench bench;
        bench.state.texture.min_filter = filter;
        bench.draw(draw);
        EXPECT_EQ(bench.take_counters().texels, 256u * n);
    }
}

// [R14.10]
TEST(ManualCounters, DigestOfTwoPixels) {
    Workbench bench(vgx(), 2, 1);
    bench.run(WritePixels{{0, 0, 2, 1}, Plane::Stencil, {}, {1, 2}, 0});
    EXPECT_EQ(to_string(digest(bench.planes(), Plane::Stencil)),
              "018a82ed9ec33d2363c34a21b5d85086");
}

// [R14.10]
TEST(ManualCounters, DigestsGoBlockByBlock) {
    // 70 x 65 pixels of depth: four blocks of 64x64, 6x64, 64x1, 6x1, by hand.
    Workbench bench(vgx(), 70, 65);
    std::vector<std::uint32_t> values;
    for (std::uint32_t i = 0; i < 70 * 65; ++i) values.push_back(i * 3001 % 16777216);
    bench.run(WritePixels{{0, 0, 70, 65}, Plane::Depth, {}, values, 0});
    std::vector<unsigned char> digests;
    for (const int y0 : {0, 64})
        for (const int x0 : {0, 64}) {
            std::vector<unsigned char> bytes;
            for (int y = y0; y < std::min(y0 + 64, 65); ++y)
                for (int x = x0; x < std::min(x0 + 64, 70); ++x)
                    for (int b = 0; b < 4; ++b)
                        bytes.push_back(
                            static_cast<unsigned char>(values[std::size_t(y * 70 + x)] >> (8 * b)));
            const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
            for (const std::uint64_t half : {h.high64, h.low64})
                for (int b = 7; b >= 0; --b)
                    digests.push_back(static_cast<unsigned char>(half >> (8 * b)));
        }
    const XXH128_hash_t h = XXH3_128bits(digests.data(), digests.size());
    EXPECT_EQ(digest(bench.planes(), Plane::Depth), (Digest{h.high64, h.low64}));
}

// [R14.1]
TEST(ManualCounters, PassesAreCountedApart) {
    Workbench bench(vgx(), 4, 4);
    CommandList list;
    list.add(Clear{mask_of(Plane::Color)});
    list.add(BeginPass{"first", mask_of(Plane::Color)});
    list.add(Clear{mask_of(Plane::Color), vec4(1)});
    list.add(BeginPass{"second", 0});
    bench.run(list);
    const auto& passes = bench.machine().passes();
    ASSERT_EQ(passes.size(), 3u);
    EXPECT_EQ(passes[0].name, "");
    EXPECT_EQ(passes[1].name, "first");
    EXPECT_EQ(passes[1].counters.pixels, 16u);
    EXPECT_EQ(passes[1].digests[0], digest(bench.planes(), Plane::Color));
    EXPECT_EQ(passes[2].counters, Counters{});
}

// [R14.11]
TEST(ManualCounters, QueriesCountWhatIsWritten) {
    test::Workbench bench(opengl(), 32, 32);
    bench.state.depth.test = true;
    bench.clear();
    const auto square = [](float z) {
        return Draw{.mesh = make_mesh(test::mesh_data(
                        Primitive::Quads, {{0, 0, z}, {16, 0, z}, {16, 16, z}, {0, 16, z}}))};
    };
    bench.run(BeginPass{"a"});
    bench.draw(square(100));
    bench.run(Query{7});
    bench.draw(square(100));
    bench.run(BeginPass{"b"});
    bench.state.color_mask = {false, false, false, false};
    bench.draw(square(50));
    bench.run(Query{7, false});
    bench.draw(square(10));
    bench.compare();
    const std::vector<PassReport>& passes = bench.machine().passes();
    EXPECT_TRUE(passes[1].queries.empty());
    EXPECT_EQ(passes[2].queries, (std::vector<QueryResult>{{7, 256}}));
    EXPECT_EQ(query_result(passes, 7), 256u);
    EXPECT_EQ(query_result(passes, 8), std::nullopt);
}

// [R14.11]
TEST(ManualCounters, AKeyMayEndTwiceInAPass) {
    test::Workbench bench(opengl(), 8, 8);
    for (const int pixels : {3, 4}) {
        bench.run(Query{7});
        bench.write({0, 0, pixels, 1}, {});
        bench.run(Query{7, false});
    }
    bench.compare();
    const std::vector<PassReport>& passes = bench.machine().passes();
    EXPECT_EQ(passes.back().queries, (std::vector<QueryResult>{{7, 3}, {7, 4}}));
    EXPECT_EQ(query_result(passes, 7), 4u);
}

// [R14.11]
TEST(ManualCounters, AQueryOutlivesForgottenPasses) {
    test::Workbench bench(opengl(), 8, 8);
    bench.write({0, 0, 3, 1}, {});
    bench.run(Query{1});
    bench.write({0, 0, 4, 1}, {});
    bench.take_counters();
    bench.write({0, 0, 5, 1}, {});
    bench.take_counters();
    bench.run(Query{1, false});
    bench.compare();
    EXPECT_EQ(query_result(bench.machine().passes(), 1), 9u);
}

// [R1.4] [R5.7]
TEST(ManualCounters, QueriesAreAnExtensionAndDoNotNest) {
    const auto refused = [](const Profile& profile, Query first, Query second) {
        test::Workbench bench(profile, 4, 4);
        return test::error_of([&] {
            bench.run(first);
            bench.run(second);
        });
    };
    EXPECT_EQ(refused(ideal(), {1}, {1, false}),
              "command 1 (Query): extension occlusion_query is not in profile ideal");
    EXPECT_EQ(refused(opengl(), {1}, {2}),
              "command 1 (Query): query 1 is active; expected its end before");
    EXPECT_EQ(refused(opengl(), {1}, {2, false}),
              "command 1 (Query): query 2 is not active; expected its begin before");
    EXPECT_EQ(refused(opengl(), {1}, {1, false}), "");
}

}  // namespace
}  // namespace gw
