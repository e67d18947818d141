// docs/manual/texture.md: the worked examples.
#include "gw/stages/texels.h"
#include "gw/stages/texgen.h"
#include "gw/stages/vertex.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

using test::Workbench;

// [R10.1] [R10.2] [R10.3]
TEST(ManualTexture, SphereAndRefractionMap) {
    const dvec4 p(0, 0, -2, 1);
    const auto st = [&](TexGen gen, const dvec3& n, double eta) {
        return texture_coordinates({.gen = gen, .eta = eta}, {{7, 7, 0, 1}, p, p, dvec3(p), n});
    };
    EXPECT_EQ(st(TexGen::SphereMap, {0, 0, 1}, 1), dvec4(0.5, 0.5, 0, 1));
    const dvec4 slanting = st(TexGen::SphereMap, {0.6, 0, 0.8}, 1);
    EXPECT_NEAR(slanting.x, 0.8, 1e-15);
    EXPECT_NEAR(slanting.y, 0.5, 1e-15);

    const dvec3 d = refracted({0, 0, -1}, {0.6, 0, 0.8}, 0.5);
    EXPECT_NEAR(d.x, -0.332364, 1e-6);
    EXPECT_EQ(d.y, 0);
    EXPECT_NEAR(d.z, -0.943151, 1e-6);
    EXPECT_NEAR(d.x * d.x + d.z * d.z, 1, 1e-15);
    // Total reflection out of the denser medium at a grazing angle.
    EXPECT_EQ(refracted({0.8, 0, -0.6}, {0, 0, 1}, 1.5), reflected({0.8, 0, -0.6}, {0, 0, 1}));
    EXPECT_EQ(sphere_map({0, 0, -1}), dvec2(0.5, 0.5));  // straight ahead: m is 0
}

// [R10.20] [R10.21]
TEST(ManualTexture, ARuleForEachCoordinate) {
    TextureState t{.gen = TexGen::PerCoordinate};
    t.coordinates[0] = {CoordinateMode::ObjectLinear, {1, 0, 0, 2}};
    t.coordinates[1] = {CoordinateMode::EyeLinear, {0, 0, -0.5, 1}};
    const TexgenInput vertex{{7, 8, 9, 10}, {3, 4, 5, 1}, {3, 4, -6, 2}, {1.5, 2, -3}, {0, 0, 1}};
    EXPECT_EQ(texture_coordinates(t, vertex), dvec4(5, 5, 9, 10));
    t.coordinates[0].mode = CoordinateMode::SphereMap;
    EXPECT_EQ(texture_coordinates(t, vertex)[0],
              sphere_map(reflected(normalized(vertex.p_eye), {0, 0, 1})).x);
    t.gen = TexGen::None;
    t.matrix[0] = {2, 0, 0, 1};
    EXPECT_EQ(texture_coordinates(t, vertex), dvec4(14, 8, 9, 17));
}

// [R10.22]
TEST(ManualTexture, OnlyCoordinatesWhoseQCanDifferAreDivided) {
    MeshData mesh = test::mesh_data(Primitive::Points, {{0, 0, 0}});
    Draw draw{.mesh = make_mesh(mesh)};
    TextureState t;
    EXPECT_FALSE(divides_by_q(t, draw));
    CurrentValues values;
    values.texcoord = {1, 1, 1, 2};
    draw.current = std::make_shared<const CurrentValues>(values);
    EXPECT_TRUE(divides_by_q(t, draw));
    mesh.texcoords = {{1, 2}};
    draw.mesh = make_mesh(mesh);
    EXPECT_FALSE(divides_by_q(t, draw));
    mesh.texcoords_rq = {{0, 1}};
    draw.mesh = make_mesh(mesh);
    EXPECT_TRUE(divides_by_q(t, draw));
    t.gen = TexGen::SphereMap;
    EXPECT_FALSE(divides_by_q(t, draw));
    t.matrix[2][3] = 0.5;
    EXPECT_TRUE(divides_by_q(t, draw));
    t = {.gen = TexGen::PerCoordinate};
    draw = {.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0, 0, 0}}))};
    EXPECT_FALSE(divides_by_q(t, draw));
    t.coordinates[3].mode = CoordinateMode::ObjectLinear;
    EXPECT_TRUE(divides_by_q(t, draw));
}

/// Red 0, 80, 160, 240.
TextureRef steps() {
    std::vector<std::uint8_t> texels;
    for (const int red : {0, 80, 160, 240})
        for (const int c : {red, 0, 0, 255}) texels.push_back(static_cast<std::uint8_t>(c));
    return make_texture8("steps", 4, 1, texels);
}

/// A square of `size` pixels with s = 0 .. 1; red at pixel x.
int red(int size, int x, MinFilter min, MagFilter mag, Wrap wrap = Wrap::Repeat) {
    Workbench bench;
    const auto side = float(size);
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}});
    square.texcoords = {{0, 0}, {1, 0}, {1, 0}, {0, 0}};
    Draw draw{.mesh = make_mesh(square)};
    draw.map.texture = steps();
    bench.state.texture.min_filter = min;
    bench.state.texture.mag_filter = mag;
    bench.state.texture.wrap_s = wrap;
    bench.draw(draw);
    return bench.color(x, 1)[0];
}

// [R10.8] [R10.9] [R10.10] [R10.11]
TEST(ManualTexture, NearestAndLinear) {
    EXPECT_EQ(red(16, 5, MinFilter::Nearest, MagFilter::Nearest), 80);
    EXPECT_EQ(red(16, 5, MinFilter::Linear, MagFilter::Linear), 70);
    // The first centre, s = 1/32: half a texel left of texel 0 is texel 3, or again texel 0.
    EXPECT_EQ(red(16, 0, MinFilter::Linear, MagFilter::Linear, Wrap::Repeat),
              90);  // p - 128 = -96: 240 * 96 / 256
    EXPECT_EQ(red(16, 0, MinFilter::Linear, MagFilter::Linear, Wrap::Clamp), 0);
}

/// Red at pixel x of a square of 64 pixels with s = from .. to; both filters Nearest.
int wide_red(int x, float from, float to, Wrap wrap) {
    Workbench bench(ideal(), 64, 64);
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}});
    square.texcoords = {{from, 0}, {to, 0}, {to, 0}, {from, 0}};
    Draw draw{.mesh = make_mesh(square)};
    draw.map.texture = steps();
    bench.state.texture.min_filter = MinFilter::Nearest;
    bench.state.texture.mag_filter = MagFilter::Nearest;
    bench.state.texture.wrap_s = wrap;
    bench.draw(draw);
    return bench.color(x, 1)[0] / 257;
}

// [R9.19] [R10.27]
TEST(ManualTexture, WideCoordinates) {
    EXPECT_EQ(wide_red(37, 0, 4097, Wrap::Repeat), 160);
    EXPECT_EQ(wide_red(0, 0, 4097, Wrap::Repeat), 0);                     // s = 32.0078
    EXPECT_EQ(wide_red(20, 0, 4097, Wrap::Repeat), 80);                   // s = 1312.32
    EXPECT_EQ(wide_red(37, -1e6f, 1e6f, Wrap::Repeat), 0);                // s = 171875
    EXPECT_EQ(wide_red(37, -0x1p35f, -0x1p35f + 8192, Wrap::Repeat), 0);  // s is 4800 above
    EXPECT_EQ(wide_red(5, -0x1p35f, -0x1p34f, Wrap::Clamp), 0);
    EXPECT_EQ(wide_red(5, 0x1p34f, 0x1p35f, Wrap::Clamp), 240);
    // Column 32 has s = 0.6: left of it is texel 0, right of it texel 3.
    for (const auto& [x, texel] : {std::pair(0, 0), std::pair(31, 0), std::pair(32, 160),
                                   std::pair(33, 240), std::pair(63, 240)})
        EXPECT_EQ(wide_red(x, -5077.525f, 4922.475f, Wrap::Clamp), texel) << x;
}

// [R10.12] [R10.14]
TEST(ManualTexture, LevelOfDetail) {
    EXPECT_EQ(red(3, 1, MinFilter::NearestMipmapNearest, MagFilter::Nearest), 160);
    EXPECT_EQ(red(3, 1, MinFilter::NearestMipmapLinear, MagFilter::Nearest), 177);
    EXPECT_EQ(red(2, 1, MinFilter::NearestMipmapNearest, MagFilter::Nearest),
              200);  // rho = 2: level 1, 40 and 200
    // row 1 is not covered
    EXPECT_EQ(red(1, 0, MinFilter::NearestMipmapNearest, MagFilter::Nearest), 0);
}

// [R10.13]
TEST(ManualTexture, LevelsAreChosenByTheBitsOfRho) {
    const auto choose = [](MinFilter min, MagFilter mag, float rho) {
        return choose_level({.min_filter = min, .mag_filter = mag}, rho, 5);
    };
    const float above = std::nextafter(1.0f, 2.0f);
    EXPECT_TRUE(choose(MinFilter::NearestMipmapNearest, MagFilter::Nearest, 1).magnify);
    EXPECT_FALSE(choose(MinFilter::NearestMipmapNearest, MagFilter::Nearest, above).magnify);
    EXPECT_TRUE(choose(MinFilter::NearestMipmapNearest, MagFilter::Linear, 1.41421354f).magnify);
    EXPECT_FALSE(choose(MinFilter::NearestMipmapNearest, MagFilter::Linear, 1.41421366f).magnify);
    EXPECT_TRUE(choose(MinFilter::LinearMipmapLinear, MagFilter::Linear, 1).magnify);
    EXPECT_FALSE(choose(MinFilter::LinearMipmapLinear, MagFilter::Linear, above).magnify);
    for (int level = 0; level < 7; ++level) {
        const float power = std::ldexp(1.0f, level);
        const LevelChoice nearest =
            choose(MinFilter::LinearMipmapNearest, MagFilter::Nearest, power * 1.4142f);
        EXPECT_EQ(nearest.level, std::min(level, 4));
        EXPECT_EQ(choose(MinFilter::LinearMipmapNearest, MagFilter::Nearest, power * 1.4143f).level,
                  std::min(level + 1, 4));
        const LevelChoice linear =
            choose(MinFilter::LinearMipmapLinear, MagFilter::Nearest, power * 1.5f);
        EXPECT_EQ(linear.level, std::min(level, 4));
        EXPECT_EQ(linear.next, std::min(level + 1, 4));
        EXPECT_EQ(linear.weight, level < 4 ? 150u : 0u);  // 256 log2 1.5 = 149.75
    }
    EXPECT_EQ(choose(MinFilter::LinearMipmapLinear, MagFilter::Nearest, HUGE_VALF).level, 4);
}

// [R10.17]
TEST(ManualTexture, EnvironmentsByHand) {
    // Fragment (200, 100, 50, 128), texel (10, 20, 30, 64), constant (255, 0, 128, 7); 8 bits.
    const auto drawn = [](TexEnv env) {
        Workbench bench;
        MeshData square =
            test::mesh_data(Primitive::Quads, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                            std::vector<vec4>(4, vec4(200, 100, 50, 128) / 255.0f));
        Draw draw{.mesh = make_mesh(square)};
        draw.map.texture = make_texture8("one", 1, 1, std::vector<std::uint8_t>{10, 20, 30, 64});
        bench.state.texture.env = env;
        bench.state.texture.env_color = vec4(255, 0, 128, 7) / 255.0f;
        bench.draw(draw);
        return bench.color(1, 1);
    };
    EXPECT_EQ(drawn(TexEnv::Modulate), (Rgba{8, 8, 6, 32}));  // 7.84, 7.84, 5.88, 32.13
    // 149.80 + 2.51, 74.90 + 5.02, 37.45 + 7.53
    EXPECT_EQ(drawn(TexEnv::Decal), (Rgba{153, 80, 45, 128}));
    // 192.16 + 10, 92.16 + 0, 44.12 + 15.06
    EXPECT_EQ(drawn(TexEnv::Blend), (Rgba{202, 92, 59, 32}));
    EXPECT_EQ(drawn(TexEnv::Replace), (Rgba{10, 20, 30, 64}));
}

// [R10.4] [R10.18] [R10.19]
// [R10.4] [R10.18]
TEST(ManualTexture, ShadowsByComparison) {
    // A depth slot of one texel, 0.5: r = 0.25 is lit, 0.75 is in shadow. q = 0 is behind the
    // projector and lit.
    for (const auto& [r, q, lit] :
         {std::tuple(0.25, 1.0, true), std::tuple(0.75, 1.0, false), std::tuple(0.75, 0.0, true),
          std::tuple(1.0, 2.0, true), std::tuple(1.5, 2.0, false)}) {
        Workbench bench(reality(), 16, 16);
        bench.clear(all_planes, vec4(0), 0.5);
        bench.run(CopyTexture{1, Plane::Depth, {0, 0, 1, 1}});
        bench.state.texture.gen = TexGen::EyeLinear;
        bench.state.texture.shadow_compare = true;
        bench.state.texture.eye_linear = dmat4(0);
        bench.state.texture.eye_linear[3] = {0.5, 0.5, r, q};
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads,
                                                    {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}))};
        draw.map.slot = 1;
        bench.draw(draw);
        EXPECT_EQ(bench.color(1, 1), lit ? (Rgba{4095, 4095, 4095, 4095}) : (Rgba{}))
            << r << " " << q;
    }
}

/// A texture whose levels have one value each.
Texture levels_of(const std::vector<std::array<std::uint16_t, 4>>& values, int side) {
    Texture t{.name = "levels"};
    for (const auto& value : values) {
        std::vector<std::uint16_t> rgba;
        for (int i = 0; i < side * side; ++i) rgba.insert(rgba.end(), value.begin(), value.end());
        t.levels.push_back({side, side, std::move(rgba)});
        side = std::max(1, side / 2);
    }
    return t;
}

/// The colour at (1, 1) of a square of 16 pixels under the texture; s, t = 0 .. `repeats`.
Rgba textured(Texture texture, const TextureState& state, float repeats = 1,
              const Profile& profile = opengl(), vec4 color = vec4(1)) {
    Workbench bench(profile, 16, 16);
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {16, 0, 0}, {16, 16, 0}, {0, 16, 0}},
                        std::vector<vec4>(4, color));
    square.texcoords = {{0, 0}, {repeats, 0}, {repeats, repeats}, {0, repeats}};
    Draw draw{.mesh = make_mesh(square)};
    draw.map.texture = make_texture(std::move(texture));
    bench.state.texture = state;
    bench.draw(draw);
    return bench.color(1, 1);
}

constexpr std::uint16_t half_up = 257 * 128, quarter = 257 * 64, full = 65535;

// [R10.23]
TEST(ManualTexture, GivenLevelsAreNotMeans) {
    const Texture t = levels_of({{full, 0, 0, full}, {0, full, 0, full}, {0, 0, full, full}}, 4);
    TextureState s{.min_filter = MinFilter::NearestMipmapNearest, .mag_filter = MagFilter::Nearest};
    EXPECT_EQ(textured(t, s, 4), (Rgba{255, 0, 0, 255}));   // a texel a pixel
    EXPECT_EQ(textured(t, s, 8), (Rgba{0, 255, 0, 255}));   // two
    EXPECT_EQ(textured(t, s, 64), (Rgba{0, 0, 255, 255}));  // sixteen: the last level
    Profile coarse = opengl();
    coarse.texel_bits = 1;
    const Texture grey = levels_of({{half_up, quarter, 0, full}}, 1);
    EXPECT_EQ(textured(grey, {.env = TexEnv::Replace}), (Rgba{128, 64, 0, 255}));
    EXPECT_EQ(textured(grey, {.env = TexEnv::Replace}, 1, coarse), (Rgba{255, 0, 0, 255}));
}

// [R10.24] [R10.17]
TEST(ManualTexture, FormatsChooseTheChannels) {
    const auto with = [](TextureFormat format, TexEnv env) {
        Texture t = levels_of({{half_up, full, full, quarter}}, 1);
        t.format = format;
        const TextureState s{.env = env, .env_color = {1, 1, 1, 1}};
        return textured(std::move(t), s, 1, opengl(), {0.2f, 0.4f, 0.6f, 0.8f});  // 51 102 153 204
    };
    using enum TextureFormat;
    EXPECT_EQ(with(RGBA, TexEnv::Replace), (Rgba{128, 255, 255, 64}));
    EXPECT_EQ(with(RGB, TexEnv::Replace), (Rgba{128, 255, 255, 204}));
    EXPECT_EQ(with(Luminance, TexEnv::Replace), (Rgba{128, 128, 128, 204}));
    EXPECT_EQ(with(LuminanceAlpha, TexEnv::Replace), (Rgba{128, 128, 128, 64}));
    EXPECT_EQ(with(Alpha, TexEnv::Replace), (Rgba{51, 102, 153, 64}));
    EXPECT_EQ(with(Intensity, TexEnv::Replace), (Rgba{128, 128, 128, 128}));
    EXPECT_EQ(with(Alpha, TexEnv::Modulate), (Rgba{51, 102, 153, 51}));
    EXPECT_EQ(with(Luminance, TexEnv::Modulate), (Rgba{26, 51, 77, 204}));
    EXPECT_EQ(with(Alpha, TexEnv::Blend), (Rgba{51, 102, 153, 51}));
    EXPECT_EQ(with(Intensity, TexEnv::Blend),
              (Rgba{25 + 128, 51 + 128, 76 + 128, 102 + 128}));  // 51 127 / 255 = 25.4 ...
    EXPECT_EQ(with(RGB, TexEnv::Decal), (Rgba{128, 255, 255, 204}));
}

// [R10.25]
TEST(ManualTexture, TheBorder) {
    // One texel; its filter at s = 1/32 lies 15/32 of a texel into the border.
    const auto edge = [](Wrap wrap, bool border) {
        Texture t = levels_of({{0, 0, 0, full}}, 1);
        if (border) {
            t.border = true;
            std::vector<std::uint16_t> rgba(std::size_t{9} * 4, full);
            std::fill_n(rgba.begin() + 4 * 4, 3, std::uint16_t{0});
            t.levels[0].rgba = std::move(rgba);
        }
        TextureState s{.wrap_s = wrap, .wrap_t = Wrap::Clamp, .env = TexEnv::Replace};
        s.border_color = {0.5f, 0, 0, 1};
        return textured(std::move(t), s)[0];
    };
    EXPECT_EQ(edge(Wrap::Clamp, false), 0);
    EXPECT_EQ(edge(Wrap::Repeat, false), 0);
    EXPECT_EQ(edge(Wrap::BorderClamp, false), 52);  // s = 3/32: 128 13/32
    EXPECT_EQ(edge(Wrap::BorderClamp, true), 104);  // 255 13/32 = 103.6
}

// [R10.26]
TEST(ManualTexture, OneDimension) {
    Texture t{.name = "line", .levels = {{2, 1, {full, 0, 0, full, 0, full, 0, full}}}};
    t.dimensions = 1;
    TextureState s{.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
    s.wrap_t = Wrap::BorderClamp;
    EXPECT_EQ(textured(t, s), (Rgba{255, 0, 0, 255}));
    s.min_filter = MinFilter::Linear;
    s.mag_filter = MagFilter::Linear;
    s.wrap_s = Wrap::Clamp;
    EXPECT_EQ(textured(t, s), (Rgba{255, 0, 0, 255}));
}

}  // namespace
}  // namespace gw
