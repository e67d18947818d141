// The texture stages of OpenGL 1.2 to 1.5 through Mesa and us: units with combine, cubes, three
// dimensions, odd sizes, depths and their comparison, sRGB, levels. The window is a board of 64 squares
// of 8 x 8 pixels, each a draw of its own.
#include "tests/peer/compare.h"

#include <array>
#include <memory>

namespace gw {
namespace {

using namespace test;

class Stages : public Driver {
public:
    /// Both pictures of a board, compared.
    Tally compare(const char* what, const std::vector<CommandList>& boards) const {
        const Tally tally =
            compare_colors(execute(boards, size, size, opengl()), play(boards, opengl()).planes);
        report(GetParam(), what, tally);
        return tally;
    }
};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, Stages, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

template <typename Enum>
Enum any(Random& random, Enum last) {
    return Enum(random.between(0, std::int64_t(last)));
}

constexpr int squares = 64;

MeshRef square(int number) {
    const auto x = float(number % 8 * 8), y = float(number / 8 * 8);
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{x, y, 0}, {x + 8, y, 0}, {x + 8, y + 8, 0}, {x, y + 8, 0}};
    return make_mesh(std::move(data));
}

/// A square whose first unit has these coordinates everywhere.
Draw draw_of(int number, const vec4& color, const vec4& texcoord = {0, 0, 0, 1}) {
    Draw draw{.mesh = square(number)};
    draw.current =
        std::make_shared<const CurrentValues>(CurrentValues{.color = color, .texcoord = texcoord});
    return draw;
}

State nearest_state() {
    State state = window_state();
    state.texture = {
        .min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest, .env = TexEnv::Replace};
    return state;
}

/// A board of what make(random, state) draws.
template <class Make>
std::vector<CommandList> boards_of(int count, std::uint64_t seed, const Make& make) {
    Random random(seed);
    std::vector<CommandList> boards;
    for (int i = 0; i < count; ++i) {
        CommandList& list = boards.emplace_back();
        list.add(Clear{all_planes, {0.25f, 0.5f, 0.75f, 1}});
        for (int number = 0; number < squares; ++number) {
            State state = nearest_state();
            Draw draw = make(random, state, number);
            add(list, state, std::move(draw));
        }
    }
    return boards;
}

std::vector<std::uint16_t> random_texels(Random& random, int count) {
    std::vector<std::uint16_t> out;
    for (int i = 0; i < 4 * count; ++i) out.push_back(std::uint16_t(257 * random.between(0, 255)));
    return out;
}

/// A coordinate well inside a texel of a side of so many, or, if `outside`, of a repetition.
float inside_texel(Random& random, int side, bool outside) {
    const auto texel = float(random.between(outside ? -side : 0, (outside ? 2 : 1) * side - 1));
    return (texel + 0.25f + 0.5f * random.fraction()) / float(side);
}

Wrap some_wrap(Random& random) {
    return std::array{Wrap::Repeat, Wrap::Clamp, Wrap::ClampToBorder,
                      Wrap::MirroredRepeat}[std::size_t(random.between(0, 3))];
}

TEST_P(Stages, NearestTexelsOfOddSizesAndVolumesAgree) {
    const auto make = [](Random& random, State& state, int number) {
        const int w = int(random.between(1, 9)), h = int(random.between(1, 9)),
                  d = random.one_in(2) ? int(random.between(1, 5)) : 1;
        Texture texture{.dimensions = d > 1 ? 3 : 2};
        texture.levels.push_back({w, h, random_texels(random, w * h * d), d});
        state.texture.wrap_s = some_wrap(random);
        state.texture.wrap_t = some_wrap(random);
        state.texture.wrap_r = some_wrap(random);
        state.texture.border_color = random_color(random);
        Draw draw = draw_of(number, vec4(1),
                            {inside_texel(random, w, true), inside_texel(random, h, true),
                             inside_texel(random, d, true), 1});
        draw.map.texture = make_texture(std::move(texture));
        return draw;
    };
    const Tally tally = compare("nearest texels, odd sizes, volumes", boards_of(20, 20, make));
    EXPECT_EQ(tally.compared, 20L * size * size);
    EXPECT_EQ(tally.different, 0);
}

TEST_P(Stages, FacesOfCubesAgree) {
    const auto make = [](Random& random, State&, int number) {
        constexpr int side = 4;
        Texture cube{.cube = true};
        cube.levels.push_back({side, side, random_texels(random, 6 * side * side), 6});
        // The largest axis says the face; the others stay inside a texel.
        vec4 direction(0, 0, 0, 1);
        const int axis = int(random.between(0, 2));
        for (int i = 0; i < 3; ++i)
            direction[i] = i == axis ? (random.one_in(2) ? 1.0f : -1.0f)
                                     : 2 * inside_texel(random, side, false) - 1;
        direction *= 1 + 3 * random.fraction();
        direction.w = 1;
        Draw draw = draw_of(number, vec4(1), direction);
        draw.map.texture = make_texture(std::move(cube));
        return draw;
    };
    const Tally tally = compare("nearest texels of cubes", boards_of(20, 21, make));
    EXPECT_EQ(tally.different, 0);
}

/// A texture of one colour. Of 0 and 1 only, if `whole`.
TextureRef one_color(Random& random, bool whole) {
    std::vector<std::uint16_t> texels = random_texels(random, 1);
    if (whole)
        for (std::uint16_t& v : texels) v = v < 32768 ? 0 : 65535;
    return make_texture("", 1, 1, texels);
}
vec4 some_color(Random& random, bool whole) {
    vec4 color = random_color(random);
    if (whole)
        for (int i = 0; i < 4; ++i) color[i] = color[i] < 0.5f ? 0.0f : 1.0f;
    return color;
}

/// `whole`: without a half, which is 128 of 255 here.
CombineState some_combination(Random& random, bool whole, bool alpha) {
    CombineState s;
    do {
        s.func = any(random, alpha ? CombineFunc::Subtract : CombineFunc::Dot3Rgba);
    } while (whole && (s.func == CombineFunc::AddSigned || s.func >= CombineFunc::Dot3Rgb));
    for (CombineSource* source : {&s.source0, &s.source1, &s.source2})
        *source = any(random, CombineSource::Texture3);
    for (CombineOperand* operand : {&s.operand0, &s.operand1, &s.operand2})
        *operand = any(random, CombineOperand::OneMinusAlpha);
    s.scale = 1 << random.between(0, whole ? 2 : 0);
    return s;
}

/// All four units are on: what a unit that is off gives others is open.
Draw combined(Random& random, State& state, int number, bool whole) {
    std::array<TextureState, max_texture_units - 1> more;
    MoreBindings bindings;
    Draw draw = draw_of(number, some_color(random, whole));
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        TextureState& s = unit == 0 ? state.texture : more[unit - 1];
        s = nearest_state().texture;
        s.env = TexEnv::Combine;
        s.env_color = some_color(random, whole);
        s.combine_rgb = some_combination(random, whole, false);
        s.combine_alpha = some_combination(random, whole, true);
        (unit == 0 ? draw.map : bindings[unit - 1]).texture = one_color(random, whole);
    }
    state.more_textures.units = std::make_shared<const decltype(more)>(more);
    draw.more_maps = std::make_shared<const MoreBindings>(bindings);
    return draw;
}

TEST_P(Stages, CombinationsOfWholeColorsAgree) {
    const auto make = [](Random& random, State& state, int number) {
        return combined(random, state, number, true);
    };
    const Tally tally =
        compare("combine on four units, colours of 0 and 1", boards_of(3, 22, make));
    EXPECT_EQ(tally.different, 0);
}

TEST_P(Stages, CombinationsAreWithinAFewUnits) {
    const auto make = [](Random& random, State& state, int number) {
        return combined(random, state, number, false);
    };
    const Tally tally = compare("combine on four units, any colours", boards_of(3, 23, make));
    EXPECT_LE(tally.worst, 4);
}

TEST_P(Stages, ComparisonsOfDepthsAgree) {
    const auto make = [](Random& random, State& state, int number) {
        constexpr int side = 4;
        Texture depths{
            .format = std::array{TextureFormat::Luminance, TextureFormat::Intensity,
                                 TextureFormat::Alpha}[std::size_t(random.between(0, 2))],
            .given_levels = true,
            .depths = true};
        std::vector<std::uint16_t> texels;
        for (int i = 0; i < side * side; ++i)
            texels.insert(texels.end(), {std::uint16_t(random.between(0, 255) << 8), 0, 0, 0});
        depths.levels.push_back({side, side, texels, 1});
        state.texture.shadow_compare = true;
        state.texture.compare_func = any(random, CompareFunc::Always);
        state.texture.env = random.one_in(2) ? TexEnv::Replace : TexEnv::Modulate;
        // Between two depths, so that no rounding decides.
        const float r = (float(random.between(-1, 255)) + 0.5f) / 256;
        Draw draw = draw_of(number, some_color(random, true),
                            {inside_texel(random, side, true), inside_texel(random, side, true),
                             std::max(r, 0.0f), 1});
        draw.map.texture = make_texture(std::move(depths));
        return draw;
    };
    const Tally tally = compare("comparisons of depths", boards_of(20, 24, make));
    EXPECT_EQ(tally.different, 0);
}

TEST_P(Stages, DecodedColorsAreWithinOneUnit) {
    const auto make = [](Random& random, State&, int number) {
        Texture texture{.srgb = true};
        texture.levels.push_back({1, 1, random_texels(random, 1), 1});
        Draw draw = draw_of(number, vec4(1));
        draw.map.texture = make_texture(std::move(texture));
        return draw;
    };
    const Tally tally = compare("sRGB", boards_of(20, 25, make));
    EXPECT_LE(tally.worst, 1);
}

/// Squares of 8 pixels that show 8 to 64 texels: levels 0 to 3, biased by less than a half.
TEST_P(Stages, NearestLevelsAgree) {
    const auto make = [](Random& random, State& state, int number) {
        Texture texture;
        for (int side = 64; side > 0; side /= 2) {
            const std::vector<std::uint16_t> color = random_texels(random, 1);
            std::vector<std::uint16_t> all;
            for (int i = 0; i < side * side; ++i) all.insert(all.end(), color.begin(), color.end());
            texture.levels.push_back({side, side, std::move(all), 1});
        }
        texture.given_levels = true;
        state.texture.exact_rho = true;
        state.texture.min_filter = MinFilter::NearestMipmapNearest;
        state.texture.lod.bias = float(random.between(-3, 3)) / 8 + float(random.between(0, 2));
        if (random.one_in(3)) state.texture.lod.min = float(random.between(1, 4));
        if (random.one_in(3)) state.texture.lod.max = float(random.between(4, 6));
        const float span = 0.125f * float(1 << random.between(0, 3));
        MeshData data = square(number)->data();
        data.texcoords = {{0, 0}, {span, 0}, {span, span}, {0, span}};
        Draw draw{.mesh = make_mesh(std::move(data))};
        draw.map.texture = make_texture(std::move(texture));
        return draw;
    };
    const Tally tally = compare("nearest levels with a bias", boards_of(20, 26, make));
    EXPECT_EQ(tally.different, 0);
}

TEST_P(Stages, SeparateBlendsAndSecondaryColorsAreWithinOneUnit) {
    const auto make = [](Random& random, State& state, int number) {
        state.blend = {.enable = true,
                       .src = any(random, BlendFactor::SrcAlphaSaturate),
                       .dst = any(random, BlendFactor::OneMinusDstAlpha),
                       .equation = any(random, BlendEquation::Max)};
        state.blend.alpha = {.separate = true,
                             .src = any(random, BlendFactor::SrcAlphaSaturate),
                             .dst = any(random, BlendFactor::OneMinusDstAlpha),
                             .equation = any(random, BlendEquation::Max)};
        state.color_sum = random.one_in(2);
        Draw draw{.mesh = square(number)};
        draw.current = std::make_shared<const CurrentValues>(CurrentValues{
            .color = random_color(random), .secondary_color = vec3(random_color(random))});
        return draw;
    };
    const Tally tally = compare("separate blends, colour sums", boards_of(20, 27, make));
    EXPECT_LE(tally.worst, 1);
}

/// A sprite of 8 x 8 pixels shows the 64 texels of its texture.
TEST_P(Stages, SpritesAgree) {
    const auto make = [](Random& random, State& state, int number) {
        state.point_sprite = true;
        state.point_size = 8;
        state.texture.coord_replace = true;
        MeshData data{.primitive = Primitive::Points};
        data.positions = {{float(number % 8 * 8 + 4), float(number / 8 * 8 + 4), 0}};
        Draw draw{.mesh = make_mesh(std::move(data))};
        draw.map.texture = make_texture("", 8, 8, random_texels(random, 64));
        return draw;
    };
    const Tally tally = compare("point sprites", boards_of(10, 28, make));
    EXPECT_EQ(tally.different, 0);
}

}  // namespace
}  // namespace gw
