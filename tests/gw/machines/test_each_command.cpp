// A small picture of each command and stage. Other files test their arithmetic.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

const std::vector<vec3> square{{8, 8, 0}, {24, 8, 0}, {24, 24, 0}, {8, 24, 0}};

std::vector<vec3> square_at(float z) {
    std::vector<vec3> s = square;
    for (vec3& v : s) v.z = z;
    return s;
}

int count(Workbench& bench, const Rgba& color) {
    return int(std::count(bench.planes().color.begin(), bench.planes().color.end(), color));
}

const Rgba white{255, 255, 255, 255};

TEST(EachCommand, ClearFillsEveryPlane) {
    Workbench bench;
    bench.clear(all_planes, {1, 0.5f, 0, 1}, 0.25, 300);
    EXPECT_EQ(bench.color(63, 63), (Rgba{255, 128, 0, 255}));
    EXPECT_EQ(bench.depth(0, 63), 4194304u);  // 0.25 * (2^24 - 1) = 4194303.75
    EXPECT_EQ(bench.stencil(63, 0), 300 & 255);
    EXPECT_EQ(bench.take_counters().pixels, 4u * 64 * 64);
}

TEST(EachCommand, ASquareCoversItsPixelsOnce) {
    Workbench bench;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(count(bench, white), 256);
    EXPECT_EQ(bench.color(8, 8), white);
    EXPECT_EQ(bench.color(24, 8), (Rgba{}));
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.primitives, 2u);
    EXPECT_EQ(c.drawn, 2u);
    EXPECT_EQ(c.fragments, 256u);
    EXPECT_EQ(c.written, 256u);
}

TEST(EachCommand, TheNearerSquareHidesTheFarther) {
    Workbench bench;
    bench.clear();
    bench.state.depth.test = true;
    bench.draw(Primitive::Quads, square_at(1000), std::vector<vec4>(4, {1, 0, 0, 1}));
    bench.draw(Primitive::Quads, square_at(2000), std::vector<vec4>(4, {0, 1, 0, 1}));
    EXPECT_EQ(count(bench, {255, 0, 0, 255}), 256);
    EXPECT_EQ(bench.depth(10, 10), 1000u);
    EXPECT_EQ(bench.take_counters().depth_killed, 256u);
}

TEST(EachCommand, BlendingAdds) {
    Workbench bench;
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    for (int i = 0; i < 3; ++i)
        bench.draw(Primitive::Quads, square, std::vector<vec4>(4, vec4(100 / 255.0f)));
    EXPECT_EQ(count(bench, white), 256);
}

TEST(EachCommand, TheStencilMasksASquare) {
    Workbench bench;
    bench.state.stencil.test = true;
    bench.state.stencil.zpass = StencilOp::Incr;
    bench.draw(Primitive::Quads, square);
    bench.clear(mask_of(Plane::Color));
    bench.state.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 1};
    bench.write({0, 0, 64, 64}, white);
    EXPECT_EQ(count(bench, white), 256);
}

TEST(EachCommand, ATextureIsModulated) {
    Workbench bench;
    const std::vector<std::uint8_t> texels{255, 0, 0,   255, 0,   255, 0,   255,
                                           0,   0, 255, 255, 255, 255, 255, 255};
    MeshData data = test::mesh_data(Primitive::Quads, square);
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Draw draw{.mesh = make_mesh(data)};
    draw.map.texture = make_texture8("four", 2, 2, texels);
    bench.state.texture.min_filter = MinFilter::Nearest;
    bench.state.texture.mag_filter = MagFilter::Nearest;
    bench.draw(draw);
    EXPECT_EQ(bench.color(15, 15), (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(bench.color(16, 15), (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(bench.color(15, 16), (Rgba{0, 0, 255, 255}));
    EXPECT_EQ(bench.color(16, 16), white);
    EXPECT_EQ(bench.take_counters().texels, 256u);
}

TEST(EachCommand, FogAtTheVertexAndPerFragment) {
    for (const FogCoordinate coordinate : {FogCoordinate::Vertex, FogCoordinate::Fragment}) {
        Workbench bench;
        bench.state.fog = {.enable = true,
                           .mode = FogMode::Linear,
                           .start = 0,
                           .end = 4,
                           .color = {0, 0, 1, 1},
                           .coordinate = coordinate};
        bench.state.projection[2] = {0, 0, 0, 0};
        bench.state.projection[3].z = 0;
        bench.draw(Primitive::Quads, square_at(-1));
        EXPECT_EQ(bench.color(10, 10), (Rgba{191, 191, 255, 255}));
    }
}

TEST(EachCommand, AccumulationAveragesTwoPictures) {
    Workbench bench;
    bench.clear();
    bench.clear(mask_of(Plane::Color), {1, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Accum, 1});
    bench.clear(mask_of(Plane::Color), {0, 1, 0, 0});
    bench.run(Accumulate{AccumOp::Accum, 1});
    bench.run(Accumulate{AccumOp::Return, 0.5f});
    EXPECT_EQ(bench.accum(3, 3), (std::array<std::int32_t, 4>{255, 255, 0, 0}));
    EXPECT_EQ(bench.color(3, 3), (Rgba{128, 128, 0, 0}));
}

TEST(EachCommand, SpansArePixelsOfOneRow) {
    Workbench bench;
    bench.run(WriteSpans{{{60, 5, 10, 0, true}, {2, 6, 2, 1, false}},
                         {{1, 1, 1, 1}, {2, 2, 2, 2}, {3, 3, 3, 3}},
                         7});
    EXPECT_EQ(count(bench, {1, 1, 1, 1}), 4);
    EXPECT_EQ(bench.color(2, 6), (Rgba{2, 2, 2, 2}));
    EXPECT_EQ(bench.color(3, 6), (Rgba{3, 3, 3, 3}));
}

TEST(EachCommand, PixelRectanglesReadBack) {
    Workbench bench;
    bench.run(WritePixels{{4, 4, 2, 2}, Plane::Depth, {}, {1, 2, 3, 4}, 0});
    bench.run(WritePixels{{4, 4, 2, 1}, Plane::Stencil, {}, {5, 6}, 0});
    bench.run(Copy{Plane::Depth, {4, 4, 2, 2}, 5, 5});
    bench.run(Read{9, Plane::Depth, {4, 4, 3, 3}});
    bench.run(Read{10, Plane::Stencil, {4, 4, 2, 1}});
    EXPECT_EQ(bench.readbacks().at(9).values,
              (CacheAlignedVector<std::uint32_t>{1, 2, 0, 3, 1, 2, 0, 3, 4}));
    EXPECT_EQ(bench.readbacks().at(10).values, (CacheAlignedVector<std::uint32_t>{5, 6}));
}

// [R10.16] [R13.6]
TEST(EachCommand, ACopiedTextureIsLookedUp) {
    Workbench bench;
    bench.write({0, 0, 4, 4}, {10, 20, 30, 40});
    bench.run(CopyTexture{3, Plane::Color, {0, 0, 4, 4}});
    MeshData data = test::mesh_data(Primitive::Quads, square);
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Draw draw{.mesh = make_mesh(data)};
    draw.map.slot = 3;
    bench.state.texture.env = TexEnv::Replace;
    bench.draw(draw);
    EXPECT_EQ(count(bench, {10, 20, 30, 40}), 256 + 16);
}

TEST(EachCommand, LinesAndPoints) {
    Workbench bench;
    bench.draw(Primitive::Lines, {{2, 2, 0}, {12, 7, 0}});
    EXPECT_EQ(count(bench, white), 10);
    bench.state.point_size = 3;
    bench.draw(Primitive::Points, {{40.5f, 40.5f, 0}});
    EXPECT_EQ(count(bench, white), 19);
    EXPECT_EQ(bench.color(39, 39), white);
    EXPECT_EQ(bench.color(41, 41), white);
    bench.clear();
    bench.state.polygon_mode = PolygonMode::Line;
    bench.draw(Primitive::Quads,
               {{8.5f, 8.5f, 0}, {24.5f, 8.5f, 0}, {24.5f, 24.5f, 0}, {8.5f, 24.5f, 0}});
    EXPECT_EQ(count(bench, white), 64);  // each side lacks its last point
}

}  // namespace
}  // namespace gw
