// docs/manual/texture.md, "Textures with r": worked examples.
#include "gw/base/arithmetic.h"
#include "gw/stages/textures/layers.h"
#include "tests/gw/workbench.h"

#include <vector>

namespace gw {
namespace {

using test::Workbench;

/// The texel of a point with these coordinates.
Rgba looked_up(Texture given, const TextureState& state, const vec4& strq,
               const Profile& profile = opengl()) {
    Workbench bench(profile, 1, 1);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
    CurrentValues current;
    current.texcoord = strq;
    draw.current = std::make_shared<const CurrentValues>(current);
    draw.map.texture = make_texture(std::move(given));
    bench.state.texture = state;
    bench.state.texture.env = TexEnv::Combine;
    bench.state.texture.combine_rgb.func = bench.state.texture.combine_alpha.func =
        CombineFunc::Replace;
    bench.draw(draw);
    const Rgba out = bench.color(0, 0);
    // A rectangle of pixels finds the same, if it magnifies.
    DrawPixels pixels{.width = 1, .height = 1, .map = draw.map};
    pixels.raster.texcoord = strq;
    bench.run(pixels);
    EXPECT_EQ(bench.color(0, 0), out);
    return out;
}

TextureState nearest() {
    return {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
}

Texture depth_texture(std::uint32_t depth, TextureFormat format) {
    Texture t{.name = "depth"};
    t.format = format;
    t.depths = true;
    t.levels = {{1, 1, {std::uint16_t(depth >> 16), std::uint16_t(depth & 0xFFFF), 7, 9}}};
    return t;
}

// [R10.40]
TEST(ManualWithR, DepthsAreExact) {
    for (const std::uint32_t depth : {0u, 1u, 0x7FFFFFu, 0x800000u, 0xFFFFFEu, 0xFFFFFFu}) {
        const Texels texels = make_texels(
            *make_texture(depth_texture(rescale(depth, 24, 32), TextureFormat::Luminance)),
            texel_bits_of(opengl()));
        EXPECT_EQ(texels.depths, std::vector{depth});
    }
    EXPECT_EQ(make_texels(*make_texture(depth_texture(0x80000080, TextureFormat::Alpha)),
                          texel_bits_of(opengl()))
                  .depths,
              std::vector{0x800000u});
    Profile deep = opengl();
    deep.depth_bits = 32;
    EXPECT_EQ(make_texels(*make_texture(depth_texture(0xFFFFFFFE, TextureFormat::Alpha)),
                          texel_bits_of(deep))
                  .depths,
              std::vector{0xFFFFFFFEu});
    // As colours: 0x40000000 is a quarter, 64.
    const vec4 at{0.5f, 0.5f, 0, 1};
    EXPECT_EQ(looked_up(depth_texture(0x40000000, TextureFormat::Luminance), nearest(), at),
              (Rgba{64, 64, 64, 255}));
    EXPECT_EQ(looked_up(depth_texture(0x40000000, TextureFormat::Intensity), nearest(), at),
              (Rgba{64, 64, 64, 64}));
    EXPECT_EQ(looked_up(depth_texture(0x40000000, TextureFormat::Alpha), nearest(), at),
              (Rgba{0, 0, 0, 64}));
}

/// Whether r passes against the depth 0x800000 of 24 bits.
bool passes(CompareFunc func, float r, float q = 1) {
    TextureState s = nearest();
    s.shadow_compare = true;
    s.compare_func = func;
    const Rgba found = looked_up(depth_texture(0x80000080, TextureFormat::Intensity), s,
                                 {0.5f * q, 0.5f * q, r, q});
    EXPECT_TRUE(found == (Rgba{0, 0, 0, 0}) || found == (Rgba{255, 255, 255, 255}));
    return found[0] != 0;
}

// [R10.41]
TEST(ManualWithR, EveryComparison) {
    using enum CompareFunc;
    const float below = 0.49999997f, above = 0.50000006f;  // r' of 0x7FFFFF, 0x800001
    const auto results = [&](CompareFunc f) {
        return std::array{passes(f, below), passes(f, 0.5f), passes(f, above)};
    };
    EXPECT_EQ(results(Never), (std::array{false, false, false}));
    EXPECT_EQ(results(Less), (std::array{true, false, false}));
    EXPECT_EQ(results(Equal), (std::array{false, true, false}));
    EXPECT_EQ(results(LEqual), (std::array{true, true, false}));
    EXPECT_EQ(results(Greater), (std::array{false, false, true}));
    EXPECT_EQ(results(NotEqual), (std::array{true, false, true}));
    EXPECT_EQ(results(GEqual), (std::array{false, true, true}));
    EXPECT_EQ(results(Always), (std::array{true, true, true}));
    // r is divided by q, and clamped; behind the projector all is lit (R10.19).
    EXPECT_TRUE(passes(Equal, 1, 2));
    EXPECT_TRUE(passes(Less, -5));
    EXPECT_FALSE(passes(LEqual, 7));
    EXPECT_TRUE(passes(Never, 0.5f, -1));
}

// [R10.41]
TEST(ManualWithR, ComparisonsAreCompleted) {
    TextureState s = nearest();
    s.shadow_compare = true;
    s.compare_func = CompareFunc::Never;
    const vec4 at{0.5f, 0.5f, 0.5f, 1};
    EXPECT_EQ(looked_up(depth_texture(0, TextureFormat::Luminance), s, at), (Rgba{0, 0, 0, 255}));
    EXPECT_EQ(looked_up(depth_texture(0, TextureFormat::Alpha), s, at), (Rgba{0, 0, 0, 0}));
    // The border's depth: outside, r = 1/2 is less than 1.
    s.compare_func = CompareFunc::Less;
    s.wrap_s = Wrap::ClampToBorder;
    s.border_color.x = 1;
    EXPECT_EQ(looked_up(depth_texture(0, TextureFormat::Intensity), s, {1.5f, 0.5f, 0.5f, 1}),
              (Rgba{255, 255, 255, 255}));
    s.wrap_s = Wrap::Repeat;
    EXPECT_EQ(looked_up(depth_texture(0, TextureFormat::Intensity), s, {1.5f, 0.5f, 0.5f, 1}),
              (Rgba{0, 0, 0, 0}));
}

/// Face k of n x n texels is red 40 k, one texel of face 3 is 255.
Texture cube(int n) {
    Texture t{.name = "cube"};
    t.cube = true;
    TextureLevel level{n, n, {}, 6};
    for (int k = 0; k < 6; ++k)
        for (int i = 0; i < n * n; ++i)
            for (const int c : {k == 3 && i == 1 ? 255 : 40 * k, 0, 0, 255})
                level.rgba.edit().push_back(std::uint16_t(257 * c));
    t.levels = {level};
    return t;
}
int cube_red(const vec3& d, const TextureState& s = nearest(), int n = 2) {
    return looked_up(cube(n), s, {d.x, d.y, d.z, 1})[0];
}

// [R10.42]
TEST(ManualWithR, Cubes) {
    const auto at = [](double x, double y, double z) { return face_point({x, y, z}); };
    EXPECT_EQ(at(1, 0.5, -0.25).face, 0);
    EXPECT_EQ(at(1, 0.5, -0.25).s, 0.625);
    EXPECT_EQ(at(1, 0.5, -0.25).t, 0.25);
    // Each face's s and t: a direction with coordinates 1/2 and 1/4 beside the largest.
    const auto st = [&](double x, double y, double z) {
        return std::array{at(x, y, z).s, at(x, y, z).t};
    };
    EXPECT_EQ(st(-1, 0.5, 0.25), (std::array{0.625, 0.25}));
    EXPECT_EQ(st(0.5, 1, 0.25), (std::array{0.75, 0.625}));
    EXPECT_EQ(st(0.5, -1, 0.25), (std::array{0.75, 0.375}));
    EXPECT_EQ(st(0.5, 0.25, 1), (std::array{0.75, 0.375}));
    EXPECT_EQ(st(0.5, 0.25, -1), (std::array{0.25, 0.375}));
    EXPECT_EQ(at(1, 1, -1).face, 0);
    EXPECT_EQ(at(0.5, -1, 1).face, 3);
    EXPECT_EQ(at(0, 0, 0).face, 0);
    EXPECT_EQ(at(0, 0, 0).s, 0.5);
    EXPECT_EQ(cube_red({1, 0.5f, -0.25f}), 0);
    EXPECT_EQ(cube_red({-1, 0.5f, -0.25f}), 40);
    EXPECT_EQ(cube_red({0.1f, 0.8f, 0.3f}), 80);
    EXPECT_EQ(cube_red({-0.1f, -0.8f, 0.3f}), 120);
    EXPECT_EQ(cube_red({0.1f, -0.8f, 0.3f}), 255);  // texel 1 of the lower row: s > 1/2, t < 1/2
    EXPECT_EQ(cube_red({0.1f, -0.8f, -0.3f}), 120);
    EXPECT_EQ(cube_red({0, 0, 5e-20f}), 160);
    EXPECT_EQ(cube_red({0.25f, 0.25f, -3e20f}), 200);
    // Behind: all channels are one.
    EXPECT_EQ(looked_up(cube(2), nearest(), {1, 0, 0, -1}), (Rgba{255, 255, 255, 255}));
}

// [R10.44]
TEST(ManualWithR, SeamlessCubes) {
    TextureState s;  // Linear
    const vec3 d{1, 0, -0.9375f};
    EXPECT_EQ(cube_red(d, s), 0);
    s.seamless = true;
    EXPECT_EQ(cube_red(d, s), 88);
    // One texel a face: at the corner of +x, +y and +z, weights of the texel, two edges, the corner.
    // s = t = 1/64 there: q = -124, weights 132. Edges 160 and 80 along s and t; corner
    // (2 (0 + 160 + 80) + 3) / 6 = 80.
    EXPECT_EQ(cube_red({1, 0.96875f, 0.96875f}, s, 1), 79);
    s.seamless = false;
    EXPECT_EQ(cube_red({1, 0.96875f, 0.96875f}, s, 1), 0);
}

/// A cube of 4 x 4, levels red 0, 100, 200.
TextureRef cube_of_levels() {
    Texture t{.name = "cube"};
    t.cube = true;
    for (const auto& [n, red] : {std::pair(4, 0), std::pair(2, 100), std::pair(1, 200)}) {
        TextureLevel level{n, n, {}, 6};
        for (int i = 0; i < 6 * n * n; ++i)
            for (const int c : {red, 0, 0, 255})
                level.rgba.edit().push_back(std::uint16_t(257 * c));
        t.levels.push_back(level);
    }
    return make_texture(std::move(t));
}

// [R10.38] [R10.43]
TEST(ManualWithR, CubesHaveLevels) {
    // A square of 8 pixels sees all of face +z: rho = 1/2; of 2 pixels: rho = 2, level 1; of 1 pixel:
    // rho = 4, level 2.
    const auto red_of = [&](float side) {
        Workbench bench(opengl(), 8, 8);
        MeshData square = test::mesh_data(Primitive::Quads,
                                          {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
        square.texcoords = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
        square.texcoords_rq = {{1, 1}, {1, 1}, {1, 1}, {1, 1}};
        bench.state.texture.min_filter = MinFilter::NearestMipmapNearest;
        bench.state.texture.mag_filter = MagFilter::Nearest;
        bench.draw(Draw{.mesh = make_mesh(square), .map = {cube_of_levels()}});
        return int(bench.color(0, 0)[0]);
    };
    EXPECT_EQ(red_of(8), 0);
    EXPECT_EQ(red_of(2), 100);
    EXPECT_EQ(red_of(1), 200);
}

// [R10.43] [R10.31]
TEST(ManualWithR, NoDirectionIsMagnified) {
    for (const bool exact_rho : {false, true}) {
        const auto red_of = [&](const vec3& d) {
            Workbench bench(opengl(), 1, 1);
            bench.state.texture = {.min_filter = MinFilter::NearestMipmapNearest,
                                   .mag_filter = MagFilter::Nearest};
            bench.state.texture.env = TexEnv::Replace;
            bench.state.texture.lod.min = 1;
            bench.state.texture.exact_rho = exact_rho;
            CurrentValues current;
            current.texcoord = vec4(d, 1);
            bench.draw(
                Draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}})),
                     .current = std::make_shared<const CurrentValues>(current),
                     .map = {cube_of_levels()}});
            return int(bench.color(0, 0)[0]);
        };
        EXPECT_EQ(red_of({1, 0, 0}), 100);
        EXPECT_EQ(red_of({0, 0, 0}), 0);
    }
}

// [R10.43]
TEST(ManualWithR, NormalsAndReflections) {
    Workbench bench(opengl(), 1, 1);
    const auto red_of = [&](CoordinateMode mode, const vec3& normal) {
        MeshData point = test::mesh_data(Primitive::Points, {{0.5f, 0.5f, -1}});
        point.normals = {normal};
        bench.state.texture = nearest();
        bench.state.texture.gen = TexGen::PerCoordinate;
        for (std::size_t i = 0; i < 3; ++i) bench.state.texture.coordinates[i].mode = mode;
        bench.state.texture.env = TexEnv::Replace;
        bench.state.depth_range = {0, 1};
        bench.state.projection = dmat4(1);
        bench.draw(Draw{.mesh = make_mesh(point), .map = {make_texture(cube(2))}});
        return int(bench.color(0, 0)[0]);
    };
    EXPECT_EQ(red_of(CoordinateMode::NormalMap, {0, 3, 0}), 80);
    EXPECT_EQ(red_of(CoordinateMode::NormalMap, {0, 0.5f, -1}), 200);
    // u = unit(0.5, 0.5, -1). Straight back from n = z, mirrored at n = x.
    EXPECT_EQ(red_of(CoordinateMode::ReflectionMap, {0, 0, 1}), 160);
    EXPECT_EQ(red_of(CoordinateMode::ReflectionMap, {1, 0, 0}), 200);
    EXPECT_EQ(red_of(CoordinateMode::ReflectionMap, {0, -1, -1}), 80);  // (0.5, 1, -0.5)
}

/// Slices of one texel each.
Texture volume(const std::vector<int>& reds) {
    Texture t{.name = "volume"};
    t.dimensions = 3;
    TextureLevel level{1, 1, {}, int(reds.size())};
    for (const int red : reds)
        for (const int c : {red, 0, 0, 255}) level.rgba.edit().push_back(std::uint16_t(257 * c));
    t.levels = {level};
    return t;
}

// [R10.45]
TEST(ManualWithR, Volumes) {
    const auto red_of = [](float r, Wrap wrap, bool linear, const std::vector<int>& reds) {
        TextureState s = linear ? TextureState{} : nearest();
        s.wrap_r = wrap;
        s.border_color = {1, 0, 0, 1};
        return int(looked_up(volume(reds), s, {0.5f, 0.5f, r, 1})[0]);
    };
    const std::vector<int> two{0, 200}, three{10, 20, 60};
    EXPECT_EQ(red_of(0.4f, Wrap::Repeat, false, two), 0);
    EXPECT_EQ(red_of(0.4f, Wrap::Repeat, true, two), 59);
    EXPECT_EQ(red_of(1.25f, Wrap::Repeat, true, two), 0);
    EXPECT_EQ(red_of(1.25f, Wrap::MirroredRepeat, false, two), 200);
    EXPECT_EQ(red_of(0.5f, Wrap::Repeat, false, three), 20);
    EXPECT_EQ(red_of(-0.1f, Wrap::Repeat, false, three), 60);
    EXPECT_EQ(red_of(-0.1f, Wrap::Clamp, false, three), 10);
    EXPECT_EQ(red_of(-0.1f, Wrap::ClampToBorder, false, three), 255);
    EXPECT_EQ(red_of(9, Wrap::Clamp, true, three), 60);
    // r = 1 under BorderClamp: half of the last slice, half of the border; (60 + 255) / 2.
    EXPECT_EQ(red_of(1, Wrap::BorderClamp, true, three), 158);
    EXPECT_EQ(red_of(9, Wrap::BorderClamp, true, three), 158);
}

// [R10.45] [R14.6]
TEST(ManualWithR, VolumesLookUpTwoSlices) {
    Workbench bench(opengl(), 1, 1);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
    draw.map.texture = make_texture(volume({1, 2}));
    bench.draw(draw);
    EXPECT_EQ(bench.take_counters().texels, 8u);
    bench.state.texture.min_filter = MinFilter::NearestMipmapLinear;
    bench.draw(draw);
    EXPECT_EQ(bench.take_counters().texels, 2u);
    bench.state.texture.min_filter = MinFilter::LinearMipmapLinear;
    bench.draw(draw);
    EXPECT_EQ(bench.take_counters().texels, 16u);
}

TEST(ManualWithR, NextLevelsAreMeansOfLayers) {
    const TextureLevel volume_level = volume({30, 60, 90}).levels[0];
    EXPECT_EQ(next_level(volume_level, 3).layers, 1);
    EXPECT_EQ(next_level(volume_level, 3).rgba[0], 257 * 60);
    const TextureLevel faces = next_level(cube(2).levels[0], 2);
    EXPECT_EQ(faces.layers, 6);
    EXPECT_EQ(faces.rgba[4 * 5], 257 * 200);
    EXPECT_EQ(faces.rgba[4 * 3], (3 * 257 * 120 + 257 * 255 + 2) / 4);
}

// [R10.38]
TEST(ManualWithR, KindsAreExtensions) {
    const auto refusal = [](bool Extensions::*missing, const Texture& texture,
                            const TextureState& s = {}) {
        Profile profile = opengl();
        profile.extensions.*missing = false;
        Workbench bench(profile, 1, 1);
        bench.state.texture = s;
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
        draw.map.texture = make_texture(texture);
        return test::error_of([&] { bench.draw(draw); });
    };
    EXPECT_EQ(refusal(&Extensions::texture_cube, cube(1)),
              "command 1 (Draw): extension texture_cube is not in profile opengl");
    EXPECT_EQ(refusal(&Extensions::texture_3d, volume({1})),
              "command 1 (Draw): extension texture_3d is not in profile opengl");
    EXPECT_EQ(refusal(&Extensions::texture_depth, depth_texture(1, TextureFormat::Alpha)),
              "command 1 (Draw): extension texture_depth is not in profile opengl");
    EXPECT_EQ(refusal(&Extensions::texture_depth, cube(1), {.compare_func = CompareFunc::Less}),
              "command 0 (SetState): extension texture_depth is not in profile opengl");
    EXPECT_EQ(refusal(&Extensions::texture_seamless, cube(1), {.seamless = true}),
              "command 0 (SetState): extension texture_seamless is not in profile opengl");
    EXPECT_EQ(refusal(&Extensions::texture_3d, cube(1), {.wrap_r = Wrap::Clamp}),
              "command 0 (SetState): extension texture_3d is not in profile opengl");
    TextureState normals;
    normals.coordinates[0].mode = CoordinateMode::NormalMap;
    EXPECT_EQ(refusal(&Extensions::texture_cube, volume({1}), normals),
              "command 0 (SetState): extension texture_cube is not in profile opengl");
}

}  // namespace
}  // namespace gw
