// docs/manual/texture.md, "Texture units": worked examples.
#include "gw/stages/tables.h"
#include "tests/gw/workbench.h"

#include <vector>

namespace gw {
namespace {

using test::Workbench;

TextureRef one_texel(const Rgba& texel, TextureFormat format = TextureFormat::RGBA) {
    std::vector<std::uint16_t> rgba;
    for (const std::uint16_t c : texel) rgba.push_back(static_cast<std::uint16_t>(257 * c));
    Texture t{.name = "one"};
    t.format = format;
    t.levels = {{1, 1, std::move(rgba)}};
    return make_texture(std::move(t));
}

/// Units of one texel each, and their states.
struct Units {
    std::array<TextureRef, max_texture_units> textures;
    std::array<TextureState, max_texture_units> states;

    void set(State& state) const {
        state.texture = states[0];
        state.more_textures.units = std::make_shared<const std::array<TextureState, 3>>(
            std::array{states[1], states[2], states[3]});
    }
    std::shared_ptr<const MoreBindings> more_maps() const {
        return std::make_shared<const MoreBindings>(
            MoreBindings{TextureBinding{textures[1]}, {textures[2]}, {textures[3]}});
    }
};

Rgba shaded(const Units& units, const vec4& color = vec4(1)) {
    Workbench bench(opengl(), 1, 1);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}, {color}))};
    draw.map.texture = units.textures[0];
    draw.more_maps = units.more_maps();
    units.set(bench.state);
    bench.draw(draw);
    return bench.color(0, 0);
}

const Rgba first{200, 100, 50, 64}, second{128, 0, 255, 255};

// [R10.37]
TEST(ManualUnits, InOrder) {
    Units units{.textures = {one_texel(first), one_texel(second)}};
    EXPECT_EQ(shaded(units), (Rgba{100, 0, 50, 64}));
    units.states[1].env = TexEnv::Add;
    EXPECT_EQ(shaded(units), (Rgba{255, 100, 255, 64}));
    std::swap(units.states[0].env, units.states[1].env);
    EXPECT_EQ(shaded(units, vec4(0, 0, 0, 1)), (Rgba{100, 0, 50, 64}));
    // Unit 0 may be off, and units between.
    units.textures = {nullptr, nullptr, nullptr, one_texel(first)};
    EXPECT_EQ(shaded(units), first);
    units.states[3].env = TexEnv::Replace;
    units.textures[1] = one_texel(second);
    EXPECT_EQ(shaded(units), first);
}

// [R10.37]
TEST(ManualUnits, HaveCoordinatesOfTheirOwn) {
    Workbench bench(opengl(), 2, 2);
    const TextureRef halves = make_whole_texture(
        "halves", 2, 1, std::vector<std::uint16_t>{65535, 0, 0, 65535, 0, 65535, 0, 65535});
    MeshData square =
        test::mesh_data(Primitive::Quads, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    square.more_texcoords[1].st = {{1, 0}, {0, 0}, {0, 0}, {1, 0}};
    Units units;
    units.textures[2] = units.textures[3] = halves;
    for (TextureState& state : units.states) {
        state.min_filter = MinFilter::Nearest;
        state.mag_filter = MagFilter::Nearest;
        state.env = TexEnv::Replace;
    }
    const auto reds = [&](const Draw& draw) {
        units.set(bench.state);
        bench.draw(draw);
        return std::array{bench.color(0, 0)[0], bench.color(1, 0)[0]};
    };
    Draw draw{.mesh = make_mesh(square), .more_maps = units.more_maps()};
    CurrentValues current;
    current.more_texcoords[2] = {0.25f, 0, 0, 1};
    draw.current = std::make_shared<const CurrentValues>(current);
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{255, 255}));  // unit 3: the current ones
    units.textures[3] = nullptr;
    draw.more_maps = units.more_maps();
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{0, 255}));  // unit 2: the mesh's
    units.states[2].matrix[0][0] = -1;
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{255, 0}));
    units.states[2].matrix = dmat4(1);
    square.more_texcoords[1].rq = {{0, 2}, {0, 2}, {0, 2}, {0, 2}};
    draw.mesh = make_mesh(square);
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{255, 255}));  // s / q is 0.375, 0.125
    units.states[2].gen = TexGen::PerCoordinate;
    units.states[2].coordinates[0] = {CoordinateMode::ObjectLinear, {0.5, 0, 0, 0}};
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{255, 255}));
    square.more_texcoords[1].rq.clear();
    draw.mesh = make_mesh(square);
    EXPECT_EQ(reds(draw), (std::array<std::uint16_t, 2>{255, 0}));
}

TextureState replace(CombineSource source) {
    TextureState s{.env = TexEnv::Combine};
    s.combine_rgb.func = s.combine_alpha.func = CombineFunc::Replace;
    s.combine_rgb.source0 = s.combine_alpha.source0 = source;
    return s;
}

// [R10.39]
TEST(ManualUnits, Crossbar) {
    Units units{.textures = {one_texel(first), one_texel(second)}};
    units.states[0] = replace(CombineSource::Texture1);
    EXPECT_EQ(shaded(units), (Rgba{64, 0, 255, 255}));  // 128 128 / 255
    units.states[1] = replace(CombineSource::Texture2);
    EXPECT_EQ(shaded(units), second);  // off: unit 1 changes nothing
    units.states[1] = replace(CombineSource::Texture0);
    EXPECT_EQ(shaded(units), first);
    units.states[1] = replace(CombineSource::PrimaryColor);
    EXPECT_EQ(shaded(units, vec4(1, 0, 1, 0)), (Rgba{255, 0, 255, 0}));
    units.states[1] = replace(CombineSource::Previous);
    EXPECT_EQ(shaded(units, vec4(1, 0, 1, 0)), second);
    // An argument that the function has not may be of a unit that is off.
    units.states[1] = replace(CombineSource::Texture0);
    units.states[1].combine_rgb.source1 = CombineSource::Texture3;
    EXPECT_EQ(shaded(units), first);
    units.states[1].combine_rgb.func = CombineFunc::Modulate;
    EXPECT_EQ(shaded(units), second);
    // Alpha's does not count under Dot3Rgba: 4 (72^2 + 28^2 + 78^2) / 255 = 189.05.
    units.states[1] = replace(CombineSource::Texture3);
    units.states[1].combine_rgb = {.func = CombineFunc::Dot3Rgba,
                                   .source0 = CombineSource::Texture0,
                                   .source1 = CombineSource::Texture0};
    EXPECT_EQ(shaded(units), (Rgba{189, 189, 189, 189}));
    // Colours of the format Alpha are 0.
    units.textures[1] = one_texel(second, TextureFormat::Alpha);
    units.states[1] = replace(CombineSource::Texture1);
    EXPECT_EQ(shaded(units), (Rgba{0, 0, 0, 255}));
}

// [R10.37] [R14.6]
TEST(ManualUnits, CountTheirLookUps) {
    Workbench bench(opengl(), 2, 2);
    Units units{.textures = {one_texel(first), one_texel(second), nullptr, one_texel(first)}};
    units.states[0].min_filter = MinFilter::Nearest;
    units.states[3].min_filter = MinFilter::NearestMipmapLinear;
    units.set(bench.state);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}})),
              .map = {units.textures[0]},
              .more_maps = units.more_maps()};
    bench.draw(draw);
    EXPECT_EQ(bench.take_counters().texels, 1u + 4u + 2u);
    DrawPixels pixels{.width = 2, .height = 1, .map = draw.map, .more_maps = draw.more_maps};
    pixels.raster.color = {255, 255, 255, 255};
    bench.run(pixels);
    EXPECT_EQ(bench.color(1, 0), (Rgba{78, 0, 10, 16}));
    EXPECT_EQ(bench.take_counters().texels, 2u * 7u);
}

// [R10.37]
TEST(ManualUnits, AreAnExtension) {
    Profile profile = opengl();
    profile.extensions.texture_units = false;
    const auto refusal = [&](const auto& change) {
        Workbench bench(profile, 1, 1);
        Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
        change(bench.state, draw);
        return test::error_of([&] { bench.draw(draw); });
    };
    const Units units{.textures = {nullptr, one_texel(first)}};
    EXPECT_EQ(refusal([&](State& s, Draw&) { units.set(s); }),
              "command 0 (SetState): extension texture_units is not in profile opengl");
    EXPECT_EQ(refusal([&](State&, Draw& d) { d.more_maps = units.more_maps(); }),
              "command 1 (Draw): extension texture_units is not in profile opengl");
    EXPECT_EQ(refusal([&](State& s, Draw&) {
                  s.texture.combine_alpha.source2 = CombineSource::Texture0;
              }),
              "command 0 (SetState): extension texture_units is not in profile opengl");
    EXPECT_EQ(
        refusal([](State&, Draw& d) { d.more_maps = std::make_shared<const MoreBindings>(); }), "");
}

}  // namespace
}  // namespace gw
