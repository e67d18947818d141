// Textures, fog, lines and points through Mesa and through us.
#include "tests/peer/compare.h"

namespace gw {
namespace {

using namespace test;

class Shading : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, Shading, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

TextureRef random_texture(Random& random) {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 16 * 16 * 4; ++i) texels.push_back(std::uint8_t(random.between(0, 255)));
    return make_texture8("random", 16, 16, texels);
}

/// A square over the whole window, texels of about 4 pixels, shifted by a fraction.
Draw textured_square(Random& random) {
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    const float s = random.fraction(), t = random.fraction();
    data.texcoords = {{s, t}, {s + 1, t}, {s + 1, t + 1}, {s, t + 1}};
    const vec4 color = random_color(random);
    data.colors.assign(4, color);
    Draw draw{.mesh = make_mesh(std::move(data))};
    draw.map.texture = random_texture(random);
    return draw;
}

Tally textured(const Driver& driver, MinFilter min, MagFilter mag, TexEnv env) {
    std::vector<CommandList> lists;
    Random random(8);
    for (int i = 0; i < 20; ++i) {
        State state = window_state();
        state.texture = {
            .min_filter = min, .mag_filter = mag, .env = env, .env_color = random_color(random)};
        if (i % 2) state.texture.wrap_s = state.texture.wrap_t = Wrap::Clamp;
        lists.emplace_back().add(Clear{all_planes});
        add(lists.back(), state, textured_square(random));
    }
    return compare_colors(execute(lists, size, size), driver.play(lists).planes);
}

TEST_P(Shading, NearestTexelsAgree) {
    for (const TexEnv env : {TexEnv::Replace, TexEnv::Modulate, TexEnv::Decal, TexEnv::Blend}) {
        const Tally tally = textured(*this, MinFilter::Nearest, MagFilter::Nearest, env);
        report(GetParam(), "nearest texels, environment by environment", tally);
        EXPECT_LE(tally.worst, env == TexEnv::Replace ? 0 : 1);
    }
}

TEST_P(Shading, BilinearTexelsAreWithinAFewUnits) {
    const Tally tally = textured(*this, MinFilter::Linear, MagFilter::Linear, TexEnv::Replace);
    report(GetParam(), "bilinear texels", tally);
    EXPECT_LE(tally.worst, 3);
}

/// Random pixels as a texture, drawn over all.
CommandList slotted(Random& random) {
    CommandList list;
    WritePixels pixels{.rect = {0, 0, size, size}};
    for (int i = 0; i < size * size; ++i)
        pixels.colors.push_back(
            {std::uint16_t(random.between(0, 255)), std::uint16_t(i & 255), 7, 255});
    add(list, window_state(), pixels);
    list.add(CopyTexture{5, Plane::Color, {16, 8, 32, 32}});
    State state = window_state();
    state.texture = {
        .min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest, .env = TexEnv::Replace};
    Draw draw = textured_square(random);
    draw.map = {.slot = 5};
    add(list, state, std::move(draw));
    return list;
}

TEST_P(Shading, SlotsAgree) {
    Random random(10);
    const std::vector<CommandList> lists{slotted(random), slotted(random)};
    const Tally tally = compare_colors(execute(lists, size, size), play(lists).planes);
    report(GetParam(), "a slot of the colour plane, nearest texels", tally);
    EXPECT_EQ(tally.different, 0);
}

/// A square that recedes from 2 to 20 units, white in fog of another colour.
CommandList fogged(FogMode mode, FogCoordinate coordinate) {
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{-2, -2, -2}, {2, -2, -2}, {20, 20, -20}, {-20, 20, -20}};
    State state;
    state.projection[2] = {0, 0, -34.0 / 32, -1};
    state.projection[3] = {0, 0, -66.0 / 32, 0};
    state.fog = {.enable = true, .mode = mode, .density = 0.1f, .start = 1, .end = 24};
    state.fog.color = {0.2f, 0.4f, 1, 1};
    state.fog.coordinate = coordinate;
    CommandList list;
    list.add(Clear{all_planes});
    add(list, state, Draw{.mesh = make_mesh(std::move(data))});
    return list;
}

TEST_P(Shading, FogPerFragmentIsWithinTwoUnits) {
    for (const FogMode mode : {FogMode::Linear, FogMode::Exp, FogMode::Exp2}) {
        const CommandList list = fogged(mode, FogCoordinate::Fragment);
        const Tally tally = compare_colors(execute({list}, size, size), play({list}).planes);
        report(GetParam(), "fog per fragment: linear, exp, exp2", tally);
        EXPECT_LE(tally.worst, 2);
    }
}

/// Pixels that only one of the two covers.
Tally compare_coverage(const CommandList& list, const Driver& driver) {
    const Planes ours = execute({list}, size, size)[0], theirs = driver.play({list}).planes[0];
    Tally tally;
    for_pixels([&](int, int, std::size_t p) {
        if (ours.color[p][3] != 0 || theirs.color[p][3] != 0)
            tally.add(ours.color[p][3] != theirs.color[p][3] ? 1 : 0);
    });
    return tally;
}

CommandList dots(int point_size, float fraction) {
    MeshData data{.primitive = Primitive::Points};
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k)
            data.positions.push_back({5 + 10 * i + fraction, 5 + 10 * k + fraction, 0});
    State state = window_state();
    state.point_size = point_size;
    CommandList list;
    list.add(Clear{all_planes});
    add(list, state, Draw{.mesh = make_mesh(std::move(data))});
    return list;
}

TEST_P(Shading, PointsAgree) {
    for (const int point_size : {1, 3, 5}) {
        const Tally tally = compare_coverage(dots(point_size, 0.5f), *this);
        report(GetParam(), "points of 1, 3, 5 pixels at pixel centres", tally);
        EXPECT_EQ(tally.different, 0);
    }
}

/// softpipe draws lines of its own, a column or row aside.
class LinesOfLlvmpipe : public Shading {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, LinesOfLlvmpipe, testing::Values("llvmpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

/// Random lines whose ends are multiples of 1 / `steps` pixel, moved by `shift`.
Tally compared_lines(int steps, float shift, bool diamonds, Shading& shading) {
    Random random(9);
    const auto coordinate = [&] {
        return float(random.between(0, size * steps)) / float(steps) + shift;
    };
    Tally sum;
    State state = window_state();
    state.diamond_lines = diamonds;
    for (int i = 0; i < 60; ++i) {
        MeshData data{.primitive = Primitive::Lines};
        for (int k = 0; k < 2; ++k) data.positions.push_back({coordinate(), coordinate(), 0});
        CommandList list;
        list.add(Clear{all_planes});
        add(list, state, Draw{.mesh = make_mesh(std::move(data))});
        const Tally tally = compare_coverage(list, shading);
        sum.compared += tally.compared;
        sum.different += tally.different;
        sum.worst = std::max(sum.worst, double(tally.different));
    }
    EXPECT_GT(sum.compared, 1000);
    return sum;
}

TEST_P(LinesOfLlvmpipe, DifferAtTheirEndsAndInTies) {
    const Tally sum = compared_lines(grid, 0, false, *this);
    report(GetParam(), "lines: pixels of only one; most in one line", sum);
    EXPECT_LE(sum.worst, 4);
}

// [R9.34]
TEST_P(LinesOfLlvmpipe, AreThoseOfTheDiamondRule) {
    EXPECT_EQ(compared_lines(1, 0, true, *this).different, 0);
    // llvmpipe has other pixels for ends on the tip of a diamond, and where a line between centres
    // passes the boundary of two pixels in the middle.
    EXPECT_LE(compared_lines(1, 0.5f, true, *this).worst, 4);
    const Tally sum = compared_lines(grid, 0, true, *this);
    report(GetParam(), "lines by the diamond rule: pixels of only one; most in one line", sum);
    EXPECT_LE(sum.worst, 2);
}

}  // namespace
}  // namespace gw
