// docs/manual/texture.md: the worked examples of what OpenGL 1.2 to 1.5 brought.
#include "gw/stages/tables.h"
#include "gw/stages/texels.h"
#include "tests/gw/workbench.h"

#include <vector>

namespace gw {
namespace {

using test::Workbench;

TextureRef whole(const std::vector<int>& reds, int width, int height) {
    std::vector<std::uint16_t> rgba;
    for (const int red : reds)
        for (const int c : {red, 0, 0, 255}) rgba.push_back(static_cast<std::uint16_t>(257 * c));
    return make_whole_texture("whole", width, height, rgba);
}

std::vector<int> reds(const TextureLevel& level) {
    std::vector<int> out;
    for (std::size_t i = 0; i < level.rgba.size(); i += 4) out.push_back(level.rgba[i] / 257);
    return out;
}

// [R10.28]
TEST(ManualTexture, LevelsOfOddSides) {
    const TextureRef five = whole({0, 60, 120, 180, 240}, 5, 1);
    ASSERT_EQ(five->levels.size(), 3u);
    EXPECT_EQ(reds(five->levels[1]), (std::vector<int>{48, 192}));
    EXPECT_EQ(reds(five->levels[2]), (std::vector<int>{120}));
    // 3 x 2: weights 1, 1, 1 along x. 3 x 3 to 1 x 1 is the mean of nine.
    EXPECT_EQ(reds(whole({0, 30, 60, 60, 90, 120}, 3, 2)->levels[1]), (std::vector<int>{60}));
    EXPECT_EQ(reds(whole({9, 0, 0, 0, 0, 0, 0, 0, 18}, 3, 3)->levels[1]), (std::vector<int>{3}));
    // 7 to 3: weights 3 3 1, 2 3 2, 1 3 3.
    EXPECT_EQ(reds(whole({0, 0, 70, 70, 0, 0, 7}, 7, 1)->levels[1]), (std::vector<int>{10, 50, 3}));
    const TextureRef wide = whole(std::vector<int>(8192, 5), 8192, 1);
    EXPECT_EQ(wide->levels.size(), 14u);
    EXPECT_EQ(reds(wide->levels[13]), (std::vector<int>{5}));
}

/// Red at pixel x of a row of 10 pixels with s = from .. to; both filters `mag`.
int any_size_red(const TextureRef& texture, int x, float from, float to, Wrap wrap,
                 MagFilter mag = MagFilter::Nearest) {
    Workbench bench(opengl(), 10, 10);
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
    square.texcoords = {{from, 0}, {to, 0}, {to, 0}, {from, 0}};
    Draw draw{.mesh = make_mesh(square)};
    draw.map.texture = texture;
    bench.state.texture.min_filter =
        mag == MagFilter::Linear ? MinFilter::Linear : MinFilter::Nearest;
    bench.state.texture.mag_filter = mag;
    bench.state.texture.wrap_s = wrap;
    bench.state.texture.wrap_t = Wrap::Clamp;
    bench.state.texture.env = TexEnv::Replace;
    bench.state.texture.border_color = {1, 0, 0, 1};
    bench.draw(draw);
    return bench.color(x, 1)[0];
}

// [R10.29] [R10.30]
TEST(ManualTexture, AnySizeAndWraps) {
    const TextureRef five = whole({0, 60, 120, 180, 240}, 5, 1);
    EXPECT_EQ(any_size_red(five, 3, 0, 2, Wrap::Repeat), 180);
    EXPECT_EQ(any_size_red(five, 6, 0, 2, Wrap::Repeat), 60);
    EXPECT_EQ(any_size_red(five, 6, 0, 2, Wrap::MirroredRepeat), 180);
    EXPECT_EQ(any_size_red(five, 6, 0, 2, Wrap::Clamp), 240);
    EXPECT_EQ(any_size_red(five, 6, 0, 2, Wrap::ClampToBorder), 255);
    EXPECT_EQ(any_size_red(five, 3, -2, 0, Wrap::ClampToBorder), 255);
    // Odd integer parts mirror, even ones do not, before 0 as after it: s = 7.7, -0.3 and -1.3.
    EXPECT_EQ(any_size_red(five, 3, 7, 9, Wrap::MirroredRepeat), 60);
    EXPECT_EQ(any_size_red(five, 3, -1, 1, Wrap::MirroredRepeat), 60);
    EXPECT_EQ(any_size_red(five, 3, -2, 0, Wrap::MirroredRepeat), 180);
    // A texture of powers of two mirrors too. s = 1.1: m = 4, texel 3.
    EXPECT_EQ(any_size_red(whole({0, 80, 160, 240}, 4, 1), 5, 0, 2, Wrap::MirroredRepeat), 240);
    // Wide: s = 0 .. 5000; at pixel 1 it is 750: Repeat and MirroredRepeat begin anew.
    EXPECT_EQ(any_size_red(five, 1, 0.5f, 5000.5f, Wrap::Repeat), 120);
    EXPECT_EQ(any_size_red(five, 1, 1.3f, 5001.3f, Wrap::MirroredRepeat), 180);
    // Linear at s = 1.05: 1343 - 128 = 1215: texel 4 and the border, weight 191.
    EXPECT_EQ(any_size_red(five, 5, 0.5f, 1.5f, Wrap::ClampToBorder, MagFilter::Linear), 251);
    EXPECT_EQ(any_size_red(five, 5, 0.5f, 1.5f, Wrap::MirroredRepeat, MagFilter::Linear), 240);
    EXPECT_EQ(any_size_red(five, 5, 0.5f, 1.5f, Wrap::Repeat, MagFilter::Linear), 61);
}

// [R10.31]
TEST(ManualTexture, LevelsAndBias) {
    const auto red_with = [](const TextureLodState& lod, MinFilter min) {
        Workbench bench(opengl(), 8, 8);
        MeshData square =
            test::mesh_data(Primitive::Quads, {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}});
        square.texcoords = {{0, 0}, {1, 0}, {1, 0}, {0, 0}};
        Draw draw{.mesh = make_mesh(square)};
        draw.map.texture = whole({0, 80, 160, 240}, 4, 1);
        bench.state.texture.min_filter = min;
        bench.state.texture.mag_filter = MagFilter::Nearest;
        bench.state.texture.lod = lod;
        bench.draw(draw);
        return bench.color(1, 1)[0];
    };
    const MinFilter nearest = MinFilter::NearestMipmapNearest;
    EXPECT_EQ(red_with({}, nearest), 160);           // rho = 4/3: level 0
    EXPECT_EQ(red_with({.bias = 1}, nearest), 200);  // 8/3: level 1
    EXPECT_EQ(red_with({.bias = 2}, nearest), 120);  // 16/3: level 2
    EXPECT_EQ(red_with({.max_level = 1, .bias = 2}, nearest), 200);
    EXPECT_EQ(red_with({.bias = 2, .max = 1}, nearest), 200);  // 2: level 1
    EXPECT_EQ(red_with({.min = 2}, nearest), 120);             // 4: level 2
    EXPECT_EQ(red_with({.min = 2, .max = 0}, nearest), 160);   // 1: magnified
    EXPECT_EQ(red_with({.base_level = 1}, nearest), 200);
    EXPECT_EQ(red_with({.base_level = 1, .bias = 0.75f}, nearest), 200);  // 1.12 of level 1
    EXPECT_EQ(red_with({.base_level = 7}, nearest), 120);
    EXPECT_EQ(red_with({.base_level = 2, .max_level = 1}, nearest), 120);
    EXPECT_EQ(red_with({.base_level = 1}, MinFilter::Nearest), 200);
    // Between levels 0 and 1: f = 106, red 160 + (40 * 106 + 128 >> 8) = 177; with a quarter more
    // rho is 1.5857: f is rne(256 log2(1 + 149/256)) = 169.
    EXPECT_EQ(red_with({}, MinFilter::NearestMipmapLinear), 177);
    EXPECT_EQ(red_with({.bias = 0.25f}, MinFilter::NearestMipmapLinear), 186);
}

// [R10.46]
TEST(ManualTexture, RhoByLengths) {
    Texture t{.name = "levels"};
    for (int side = 64, red = 0; side >= 1; side /= 2, red += 40) {
        TextureLevel level{side, side, {}};
        for (int i = 0; i < side * side; ++i)
            for (const int c : {red, 0, 0, 255})
                level.rgba.edit().push_back(std::uint16_t(257 * c));
        t.levels.push_back(level);
    }
    const TextureRef texture = make_texture(std::move(t));
    // 3 and 4 texels along a row, 4 and 0 along a column
    const auto texcoord = [](float x, float y) { return vec2((3 * x + 4 * y) / 64, 4 * x / 64); };
    const auto red_by = [&](bool exact) {
        Workbench bench(opengl(), 8, 8);
        MeshData square =
            test::mesh_data(Primitive::Quads, {{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
        square.texcoords = {texcoord(0, 0), texcoord(8, 0), texcoord(8, 8), texcoord(0, 8)};
        bench.state.texture.min_filter = MinFilter::NearestMipmapLinear;
        bench.state.texture.mag_filter = MagFilter::Nearest;
        bench.state.texture.exact_rho = exact;
        bench.draw(Draw{.mesh = make_mesh(square), .map = {texture}});
        return int(bench.color(3, 3)[0]);
    };
    EXPECT_EQ(red_by(false), 80);  // rho = 4: level 2
    EXPECT_EQ(red_by(true), 93);   // rho = 5: 80 + (40 * 82 + 128 >> 8)
}

// [R10.28] [R10.31]
TEST(ManualTexture, SizesWrapsAndLevelsAreExtensions) {
    const auto refusal_of = [](bool Extensions::*missing, const auto& change) {
        Profile profile = opengl();
        profile.extensions.*missing = false;
        Workbench bench(profile, 4, 4);
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{1, 1, 0}}))};
        change(bench.state.texture, draw.map);
        return test::error_of([&] { bench.draw(draw); });
    };
    EXPECT_EQ(refusal_of(&Extensions::texture_sizes,
                         [](TextureState&, TextureBinding& map) {
                             map.texture = whole({1, 2, 3}, 3, 1);
                         }),
              "command 1 (Draw): extension texture_sizes is not in profile opengl");
    EXPECT_EQ(refusal_of(&Extensions::texture_wraps,
                         [](TextureState& s, TextureBinding&) { s.wrap_t = Wrap::MirroredRepeat; }),
              "command 0 (SetState): extension texture_wraps is not in profile opengl");
    EXPECT_EQ(refusal_of(&Extensions::texture_wraps,
                         [](TextureState& s, TextureBinding&) { s.wrap_s = Wrap::ClampToBorder; }),
              "command 0 (SetState): extension texture_wraps is not in profile opengl");
    EXPECT_EQ(refusal_of(&Extensions::texture_lod,
                         [](TextureState& s, TextureBinding&) { s.lod.bias = 1; }),
              "command 0 (SetState): extension texture_lod is not in profile opengl");
}

/// A texel (200, 100, 50, 64) of any format and a fragment (128, 192, 255, 128).
Rgba combined(const TextureState& given, TextureFormat format = TextureFormat::RGBA) {
    Workbench bench(opengl(), 1, 1);
    MeshData point =
        test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}, {vec4(128, 192, 255, 128) / 255.0f});
    Draw draw{.mesh = make_mesh(point)};
    Texture texture{.name = "one"};
    texture.format = format;
    texture.levels = {{1, 1, {200 * 257, 100 * 257, 50 * 257, 64 * 257}}};
    draw.map.texture = make_texture(std::move(texture));
    bench.state.texture = given;
    bench.state.texture.env_color = vec4(255, 0, 128, 51) / 255.0f;
    bench.draw(draw);
    return bench.color(0, 0);
}

// [R10.32] [R10.33] [R10.34] [R10.35]
TEST(ManualTexture, Combine) {
    TextureState t{.env = TexEnv::Combine};
    CombineState& rgb = t.combine_rgb;
    EXPECT_EQ(combined(t), (Rgba{100, 75, 50, 32}));  // Modulate: 100.39, 75.29, 50, 32.13
    rgb.func = CombineFunc::Interpolate;
    EXPECT_EQ(combined(t), (Rgba{142, 174, 214, 32}));
    rgb.operand2 = CombineOperand::OneMinusColor;  // 0, 255, 127
    EXPECT_EQ(combined(t), (Rgba{128, 100, 153, 32}));
    rgb.func = CombineFunc::AddSigned;
    rgb.scale = 2;
    t.combine_alpha.func = CombineFunc::AddSigned;
    EXPECT_EQ(combined(t), (Rgba{255, 255, 255, 64}));
    rgb.source1 = CombineSource::Constant;
    rgb.operand1 = CombineOperand::OneMinusAlpha;  // 204
    rgb.scale = 1;
    EXPECT_EQ(combined(t), (Rgba{255, 176, 126, 64}));
    rgb.func = CombineFunc::Subtract;
    EXPECT_EQ(combined(t), (Rgba{0, 0, 0, 64}));
    rgb.operand1 = CombineOperand::Alpha;  // 51
    rgb.scale = 4;
    EXPECT_EQ(combined(t), (Rgba{255, 196, 0, 64}));  // 149, 49, -1
    rgb = {.func = CombineFunc::Dot3Rgb};
    EXPECT_EQ(combined(t), (Rgba{0, 0, 0, 64}));
    rgb.operand1 = CombineOperand::OneMinusColor;
    EXPECT_EQ(combined(t), (Rgba{184, 184, 184, 64}));
    rgb.func = CombineFunc::Dot3Rgba;
    EXPECT_EQ(combined(t), (Rgba{184, 184, 184, 184}));
    rgb = {.func = CombineFunc::Replace, .source0 = CombineSource::PrimaryColor, .scale = 2};
    t.combine_alpha = {.func = CombineFunc::Add, .source1 = CombineSource::Constant};
    EXPECT_EQ(combined(t), (Rgba{255, 255, 255, 115}));
    rgb = {.func = CombineFunc::Replace};
    EXPECT_EQ(combined(t, TextureFormat::Alpha), (Rgba{0, 0, 0, 115}));
    EXPECT_EQ(combined(t, TextureFormat::Luminance), (Rgba{200, 200, 200, 255}));
}

// [R10.32]
TEST(ManualTexture, TheEnvironmentAdd) {
    const TextureState t{.env = TexEnv::Add};
    EXPECT_EQ(combined(t), (Rgba{255, 255, 255, 32}));
    EXPECT_EQ(combined(t, TextureFormat::RGB), (Rgba{255, 255, 255, 128}));
    EXPECT_EQ(combined(t, TextureFormat::Alpha), (Rgba{128, 192, 255, 32}));
    EXPECT_EQ(combined(t, TextureFormat::Intensity), (Rgba{255, 255, 255, 255}));
    Profile profile = opengl();
    profile.extensions.texture_combine = false;
    Workbench bench(profile, 1, 1);
    bench.state.texture = t;
    EXPECT_EQ(test::error_of([&] {
                  bench.draw(Primitive::Points, {{0, 0, 0}});
              }),
              "command 0 (SetState): extension texture_combine is not in profile opengl");
}

// [R10.36]
TEST(ManualTexture, SrgbTexels) {
    EXPECT_EQ(srgb_values()[0], 0);
    EXPECT_EQ(srgb_values()[10], 199);
    EXPECT_EQ(srgb_values()[11], 219);
    EXPECT_EQ(srgb_values()[128], 14146);
    EXPECT_EQ(srgb_values()[255], 65535);
    const std::vector<std::uint16_t> texel{128 * 257, 10 * 257, 65535, 128 * 257};
    const auto looked_up = [&](bool srgb, int texel_bits) {
        Profile profile = opengl();
        profile.texel_bits = texel_bits;
        Workbench bench(profile, 1, 1);
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
        draw.map.texture = make_whole_texture("s", 1, 1, texel, srgb);
        bench.state.texture.env = TexEnv::Replace;
        bench.draw(draw);
        return bench.color(0, 0);
    };
    EXPECT_EQ(looked_up(false, 0), (Rgba{128, 10, 255, 128}));
    EXPECT_EQ(looked_up(true, 0), (Rgba{55, 1, 255, 128}));
    EXPECT_EQ(looked_up(true, 4), (Rgba{51, 0, 255, 136}));  // 3 and 8 of 15
}

// [R10.36]
TEST(ManualTexture, SrgbIsAnExtension) {
    Profile profile = opengl();
    profile.extensions.texture_srgb = false;
    Workbench bench(profile, 1, 1);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
    draw.map.texture = make_whole_texture("s", 1, 1, std::vector<std::uint16_t>(4), true);
    EXPECT_EQ(test::error_of([&] { bench.draw(draw); }),
              "command 1 (Draw): extension texture_srgb is not in profile opengl");
}

}  // namespace
}  // namespace gw
