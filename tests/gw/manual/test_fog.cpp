// docs/manual/fog.md: the worked examples, and fog against the closed form.
#include "gw/stages/fog.h"
#include "gw/stages/tables.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <cmath>

namespace gw {
namespace {

using test::Workbench;

// [R11.2] [R11.6] [R11.7]
TEST(ManualFog, FactorsAndTable) {
    const FogState linear{
        .enable = true, .mode = FogMode::Linear, .start = 0, .end = 4, .color = {0, 0, 1, 1}};
    EXPECT_EQ(fog_factor(linear, 1, 8), 191u);
    EXPECT_EQ(apply_fog({255, 255, 255, 255}, 191, {0, 0, 255, 255}, 8),
              (Rgba{191, 191, 255, 255}));

    const FogState exponential{.enable = true, .density = 0.5f};
    EXPECT_EQ(fog_factor(exponential, 2, 8), 94u);
    EXPECT_NEAR(fog_table_depth(exponential, 8), 12.4766, 1e-4);
    const auto table = fog_table(exponential, 8);
    ASSERT_EQ(table.size(), 257u);
    EXPECT_EQ(table[0], 255u);
    EXPECT_EQ(table[41], 94u);
    EXPECT_EQ(table[42], 92u);
    EXPECT_EQ(table[256], 0u);
}

/// Red of a white square at distance z in black fog, in a projection that keeps x and y.
int fogged(const FogState& fog, float z, const Profile& profile = vgx()) {
    Workbench bench(profile, 16, 16);
    bench.state.fog = fog;
    bench.state.projection[2] = {0, 0, 0, 0};
    bench.state.projection[3].z = 0;
    bench.draw(Primitive::Quads, {{0, 0, -z}, {4, 0, -z}, {4, 4, -z}, {0, 4, -z}});
    return bench.color(1, 1)[0];
}

// [R11.1] [R11.3] [R11.4] [R11.5]
TEST(ManualFog, VertexAndFragmentFogThroughTheMachine) {
    FogState fog{.enable = true, .density = 0.5f, .coordinate = FogCoordinate::Vertex};
    EXPECT_EQ(fogged(fog, 2), 94);
    fog.coordinate = FogCoordinate::Fragment;
    EXPECT_EQ(fogged(fog, 2), 94);
    EXPECT_EQ(fogged(fog, 1e30f), 0);
    // Behind the eye the fragment's distance is that before it; the vertex's is 0.
    EXPECT_EQ(fogged(fog, -2), 94);
    fog.coordinate = FogCoordinate::Vertex;
    EXPECT_EQ(fogged(fog, -2), 255);
}

// [R11.3] [R11.6]
TEST(ManualFog, APolygonFromBehindTheEyeHasTheFogOfItsPartBefore) {
    // The ground, one unit below the eye, from 40 behind it to 40 before; 90 degrees of view, the near plane at 1/2.
    Workbench bench(ideal(), 16, 16);
    bench.state.fog = {.enable = true,
                       .mode = FogMode::Linear,
                       .start = 0,
                       .end = 20,
                       .coordinate = FogCoordinate::Fragment};
    bench.state.projection = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -1}, {0, 0, -1, 0}};
    bench.draw(Primitive::Quads, {{-90, -1, 40}, {90, -1, 40}, {90, -1, -40}, {-90, -1, -40}});
    for (int y = 0; y < 8; ++y) {
        const double distance = 8 / (8 - (y + 0.5));
        EXPECT_NEAR(bench.color(8, y)[0] / 65535.0, std::max(0.0, 1 - distance / 20), 2e-3) << y;
    }
}

TEST(ManualFog, TheTableIsNearTheFormulaEverywhere) {
    for (const FogMode mode : {FogMode::Linear, FogMode::Exp, FogMode::Exp2})
        for (int i = 0; i <= 300; ++i) {
            const float z = float(i) / 20;
            FogState fog{.enable = true,
                         .mode = mode,
                         .density = 0.35f,
                         .start = 2,
                         .end = 11,
                         .coordinate = FogCoordinate::Fragment};
            const double d = 0.35f * double(z);
            const double f = mode == FogMode::Linear
                                 ? (11 - double(z)) / 9
                                 : std::exp(mode == FogMode::Exp ? -d : -(d * d));
            const double exact = 255 * std::min(1.0, std::max(0.0, f));
            EXPECT_NEAR(fogged(fog, z), exact, 1.6) << int(mode) << " " << z;
            fog.coordinate = FogCoordinate::Vertex;
            EXPECT_NEAR(fogged(fog, z), exact, 0.5001) << int(mode) << " " << z;
        }
}

TEST(ManualFog, BlackFogPlusFoggedBlackIsOnePassOfFog) {
    // Every factor and colour with a few fog colours of 8 bits; samples of 12 and 16 bits. [K3.5]
    const auto check = [](std::uint32_t f, std::uint16_t c, std::uint16_t fog, int bits) {
        const Rgba one_pass = apply_fog({c, c, c, 0}, f, {fog, fog, fog, 0}, bits);
        const Rgba black_fog = apply_fog({c, c, c, 0}, f, {}, bits),
                   black = apply_fog({}, f, {fog, fog, fog, 0}, bits);
        ASSERT_EQ(blend({true, BlendFactor::One, BlendFactor::One}, {black, black_fog, {}}, bits),
                  one_pass);
    };
    for (std::uint32_t f = 0; f < 256; ++f)
        for (int c = 0; c < 256; ++c)
            for (const int fog : {0, 1, 77, 128, 200, 254, 255})
                check(f, std::uint16_t(c), std::uint16_t(fog), 8);
    test::Random random(1);
    for (const int bits : {12, 16})
        for (int i = 0; i < 20000; ++i) {
            const auto v = [&] { return std::uint16_t(random.between(0, (1 << bits) - 1)); };
            check(v(), v(), v(), bits);
        }
}

/// Red of pixel x of a white line from (0, 0.5) to (4, 0.5) in black fog.
int fogged_line(const FogState& fog, float first, float second, int x) {
    Workbench bench(opengl(), 4, 4);
    bench.state.fog = fog;
    MeshData line = test::mesh_data(Primitive::Lines, {{0, 0.5f, 0}, {4, 0.5f, 0}});
    line.fog_coordinates = {first, second};
    bench.draw(line);
    return bench.color(x, 0)[0];
}

// [R11.8]
TEST(ManualFog, GivenCoordinates) {
    FogState fog{.enable = true,
                 .mode = FogMode::Linear,
                 .density = 0.5f,
                 .start = -4,
                 .end = 4,
                 .source = FogSource::Coordinate};
    for (const FogCoordinate where : {FogCoordinate::Fragment, FogCoordinate::Vertex}) {
        fog.coordinate = where;
        EXPECT_EQ(fogged_line(fog, -4, 4, 1), 159);
        EXPECT_EQ(fogged_line(fog, -4, 4, 2), 96);
        EXPECT_EQ(fogged_line(fog, 1e30f, 1e30f, 2), 0);
        EXPECT_EQ(fogged_line(fog, -1e30f, -1e30f, 2), 255);
    }
    fog.coordinate = FogCoordinate::Fragment;
    fog.mode = FogMode::Exp2;
    EXPECT_EQ(fogged_line(fog, -4, 4, 1), 199);
    EXPECT_EQ(fogged_line(fog, -4, 4, 2), 199);
    fog.mode = FogMode::Exp;
    EXPECT_EQ(fogged_line(fog, -4, 4, 1), 255);
    EXPECT_EQ(fogged_line(fog, -4, 4, 2), 155);  // exp(-1/2): 154.67
    fog.source = FogSource::Depth;               // the line is at the distance 0
    EXPECT_EQ(fogged_line(fog, 9, 9, 1), 255);
}

// [R1.4]
TEST(ManualFog, AGivenCoordinateIsAnExtension) {
    Workbench bench(ideal(), 4, 4);
    bench.state.fog.source = FogSource::Coordinate;
    EXPECT_EQ(test::error_of([&] { bench.clear(); }),
              "command 0 (SetState): extension fog_coordinate is not in profile ideal");
}

// [R11.8] [R5.9]
TEST(ManualFog, TheCurrentCoordinateAndTheRasterPositions) {
    Workbench bench(opengl(), 4, 4);
    bench.state.fog = {.enable = true,
                       .mode = FogMode::Linear,
                       .start = 0,
                       .end = 4,
                       .source = FogSource::Coordinate};
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
    bench.draw(draw);
    EXPECT_EQ(bench.color(0, 0)[0], 255);
    CurrentValues current;
    current.fog_coordinate = 3;
    draw.current = std::make_shared<const CurrentValues>(current);
    bench.draw(draw);
    EXPECT_EQ(bench.color(0, 0)[0], 64);  // 63.75
    DrawPixels pixels{.width = 1, .height = 1, .colors = {{255, 255, 255, 255}}};
    pixels.raster.distance = 4;
    pixels.raster.fog_coordinate = 1;
    bench.run(pixels);
    EXPECT_EQ(bench.color(0, 0)[0], 191);
    pixels.raster.fog_coordinate = -1;
    bench.run(pixels);
    EXPECT_EQ(bench.color(0, 0)[0], 255);
}

// [R6.13]
TEST(ManualFog, IdentifiersAreNeverFogged) {
    Workbench bench;
    bench.state.fog = {
        .enable = true, .mode = FogMode::Linear, .start = 0, .end = 1, .color = vec4(1)};
    bench.state.color_source = ColorSource::PolygonId;
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    square.polygon_ids = {0x010203};
    bench.draw(Draw{.mesh = make_mesh(square), .id_base = 0x20000000, .id_shift = 0});
    EXPECT_EQ(bench.color(1, 1), (Rgba{3, 2, 1, 255}));
    bench.draw(Draw{.mesh = make_mesh(square), .id_base = 0x20000000, .id_shift = 24});
    EXPECT_EQ(bench.color(1, 1), (Rgba{0x20, 0, 0, 255}));
}

}  // namespace
}  // namespace gw
