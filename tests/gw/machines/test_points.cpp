// docs/manual/rasterization.md, "Points": the worked examples.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

/// An orthographic view of 64 x 64 pixels whose unit is a pixel, with its middle on the eye's axis.
struct PointBench : Workbench {
    PointBench() : Workbench(opengl(), 64, 64) {
        state.projection = dmat4(1);
        state.projection[0][0] = state.projection[1][1] = 1.0 / 32;
        state.projection[2][2] = -1.0 / 128;
    }
    /// The number of fragments of a point.
    std::uint64_t fragments(const vec3& eye) {
        take_counters();
        draw(Primitive::Points, {eye});
        return take_counters().fragments;
    }
};

/// A texture of 4 x 4 texels: red is 16 times the column, green the row.
TextureRef counting_texture() {
    std::vector<std::uint16_t> texels;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const int values[] = {x * 16 * 257, y * 16 * 257, 0, 65535};
            for (const int value : values) texels.push_back(std::uint16_t(value));
        }
    return make_texture("counting", 4, 4, std::move(texels));
}

}  // namespace

// [R9.31]
TEST(ManualPoints, SizesByDistance) {
    PointBench bench;
    bench.state.point_size = 8;
    EXPECT_EQ(bench.fragments({3, 0, -4}), 64u);
    bench.state.point_parameters = {.constant = 0, .quadratic = 0.25f};
    EXPECT_EQ(bench.fragments({3, 0, -4}), 9u);    // 3.2
    EXPECT_EQ(bench.fragments({0, 0, -16}), 1u);   // 1
    EXPECT_EQ(bench.fragments({0, 0, -100}), 1u);  // min_size
    bench.state.point_parameters.min_size = 6;
    EXPECT_EQ(bench.fragments({3, 0, -4}), 36u);
    bench.state.point_parameters = {.constant = 0, .linear = 0.2f, .max_size = 5};
    EXPECT_EQ(bench.fragments({3, 0, -4}), 25u);  // 8
    bench.state.point_parameters = {.constant = -1, .min_size = 2, .max_size = 4};
    EXPECT_EQ(bench.fragments({3, 0, -4}), 16u);  // no size: the greatest
    bench.state.point_parameters = {.constant = 1, .min_size = 9, .max_size = 4};
    EXPECT_EQ(bench.fragments({3, 0, -4}), 16u);
}

// [R9.31]
TEST(ManualPoints, OutlinesHaveSizesByDistance) {
    PointBench bench;
    bench.state.polygon_mode = PolygonMode::Point;
    bench.state.point_parameters = {.constant = 0, .quadratic = 1 / 64.0f};  // 8 / d
    bench.draw(Primitive::Triangles, {{0, 0, -1}, {20, 0, -1}, {0, 20, -2}});
    EXPECT_EQ(bench.take_counters().fragments, 64u + 1 + 1);
}

// [R9.32]
TEST(ManualPoints, ASpriteShowsItsTexture) {
    PointBench bench;
    bench.state.point_size = 4;
    bench.state.point_sprite = true;
    bench.state.texture.env = TexEnv::Replace;
    bench.state.texture.min_filter = MinFilter::Nearest;
    bench.state.texture.mag_filter = MagFilter::Nearest;
    bench.state.texture.coord_replace = true;
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0, 0, -1}}))};
    draw.map.texture = counting_texture();
    bench.draw(draw);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(bench.color(30 + x, 30 + y),
                      (Rgba{std::uint16_t(16 * x), std::uint16_t(16 * (3 - y)), 0, 255}))
                << x << " " << y;
    bench.state.texture.coord_replace = false;  // all of it has the vertex's coordinates
    bench.draw(draw);
    EXPECT_EQ(bench.color(33, 33), (Rgba{0, 0, 0, 255}));
}

// [R9.33]
TEST(ManualPoints, SpritesAreSquares) {
    PointBench bench;
    bench.state.point_size = 8;
    bench.state.point_smooth = true;
    EXPECT_LT(bench.fragments({0, 0, -1}), 64u);
    bench.state.point_sprite = true;
    EXPECT_EQ(bench.fragments({0, 0, -1}), 64u);
}

// [R1.4]
TEST(ManualPoints, ProfilesWithoutThemRefuse) {
    const auto refused = [](auto set) {
        Workbench bench(ideal());
        set(bench.state);
        return test::error_of([&] { bench.clear(); });
    };
    EXPECT_EQ(refused([](State& s) { s.point_parameters.linear = 1; }),
              "command 0 (SetState): extension point_parameters is not in profile ideal");
    for (const auto set : {+[](State& s) { s.point_sprite = true; },
                           +[](State& s) { s.texture.coord_replace = true; }})
        EXPECT_EQ(refused(set),
                  "command 0 (SetState): extension point_sprite is not in profile ideal");
}

}  // namespace gw
