// Logical operations, blend equations and stipples through Mesa and us.
#include "tests/peer/compare.h"

namespace gw {
namespace {

using namespace test;

class OpenGL : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, OpenGL, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

/// The machine with opengl's extensions on the grid of these tests.
Profile coarse_opengl() {
    Profile p = opengl();
    p.subpixel_bits = 3;
    p.perspective_color = false;
    return p;
}

WritePixels noise(Random& random) {
    WritePixels w{.rect = {0, 0, size, size}};
    for (int i = 0; i < size * size; ++i) {
        const std::uint64_t bits = random.next();
        w.colors.push_back({std::uint16_t(bits & 255), std::uint16_t(bits >> 8 & 255),
                            std::uint16_t(bits >> 16 & 255), std::uint16_t(bits >> 24 & 255)});
    }
    return w;
}

/// Noise over noise in each of the states.
std::vector<CommandList> noise_under(const std::vector<State>& states, Random& random) {
    std::vector<CommandList> lists;
    for (const State& state : states) {
        CommandList& list = lists.emplace_back();
        add(list, window_state(), noise(random));
        add(list, state, noise(random));
    }
    return lists;
}

TEST_P(OpenGL, LogicalOperationsAgreeInEveryBit) {
    std::vector<State> states;
    for (int op = 0; op <= int(LogicOp::Set); ++op) {
        states.push_back(window_state());
        states.back().logic_op = {true, LogicOp(op)};
    }
    Random random(11);
    const std::vector<CommandList> lists = noise_under(states, random);
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "16 logical operations", tally);
    EXPECT_EQ(tally.compared, 16L * size * size);
    EXPECT_EQ(tally.different, 0);
}

TEST_P(OpenGL, BlendEquationsAreWithinOneUnit) {
    std::vector<State> states;
    for (int equation = 0; equation <= int(BlendEquation::Max); ++equation)
        for (const BlendFactor factor :
             {BlendFactor::ConstantColor, BlendFactor::OneMinusConstantColor,
              BlendFactor::ConstantAlpha, BlendFactor::OneMinusConstantAlpha}) {
            states.push_back(window_state());
            states.back().blend = {true,
                                   factor,
                                   BlendFactor::SrcAlpha,
                                   BlendEquation(equation),
                                   {0.25f, 0.5f, 0.75f, 0.6f}};
        }
    Random random(12);
    const std::vector<CommandList> lists = noise_under(states, random);
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "blend equations with constant factors", tally);
    EXPECT_EQ(tally.compared, 20L * size * size);
    EXPECT_LE(tally.worst, 1);
}

PolygonStippleState random_stipple(Random& random) {
    std::array<std::uint32_t, 32> rows;
    for (std::uint32_t& row : rows) row = std::uint32_t(random.next());
    return {std::make_shared<const std::array<std::uint32_t, 32>>(rows)};
}

TEST_P(OpenGL, StippledPolygonsAgreeAwayFromTheirSides) {
    Random random(13);
    std::vector<CommandList> lists;
    std::vector<GridTriangle> triangles;
    for (int i = 0; i < 60; ++i) {
        triangles.push_back(random_triangle(random));
        State state = window_state();
        state.polygon_stipple = random_stipple(random);
        const vec4 color = random_color(random);
        add(lists.emplace_back(), state,
            Draw{.mesh = make_mesh(mesh_of(triangles.back(), {0, 0, 0}, {color, color, color}))});
    }
    const auto ours = execute(lists, size, size, coarse_opengl()),
               theirs = play(lists, coarse_opengl()).planes;
    Tally tally;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (!near_side(triangles[i], x, y))
                tally.add(difference(ours[i].color[p], theirs[i].color[p]));
        });
    report(GetParam(), "stippled triangles", tally);
    EXPECT_GT(tally.compared, 200000);
    EXPECT_EQ(tally.different, 0);
}

/// Lines from pixel centre to pixel centre along a row or column, in either direction: their pixels
/// are the same by GL's rule and by ours.
TEST_P(OpenGL, StippledLinesAgree) {
    Random random(14);
    std::vector<CommandList> lists;
    for (int i = 0; i < 120; ++i) {
        const auto at = [&] { return float(random.between(0, size - 1)) + 0.5f; };
        const float a = at(), b = at(), c = at(), d = at();
        MeshData data{.primitive = i % 3 == 0 ? Primitive::LineStrip : Primitive::Lines};
        data.positions = {{a, c, 0}, {b, c, 0}};
        if (i % 3 == 0) data.positions.push_back({b, d, 0});
        if (i % 3 == 1) data.positions = {{c, a, 0}, {c, b, 0}};
        State state = window_state();
        state.line_stipple = {true, int(random.between(1, 5)), std::uint16_t(random.next())};
        add(lists.emplace_back(), state, Draw{.mesh = make_mesh(data)});
    }
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "stippled lines and strips", tally);
    EXPECT_EQ(tally.different, 0);
}

/// A square over the window in each format and environment, and half way into the border.
TEST_P(OpenGL, TextureFormatsAreWithinOneUnit) {
    Random random(15);
    std::vector<CommandList> lists;
    for (int format = 0; format <= int(TextureFormat::Intensity); ++format)
        for (const TexEnv env : {TexEnv::Modulate, TexEnv::Blend, TexEnv::Replace})
            for (const Wrap wrap : {Wrap::Repeat, Wrap::BorderClamp}) {
                Texture t{
                    .name = "format", .levels = {{4, 4, {}}}, .format = TextureFormat(format)};
                for (int i = 0; i < 64; ++i)
                    t.levels[0].rgba.push_back(std::uint16_t(257 * random.between(0, 255)));
                State state = window_state();
                state.texture = {.mag_filter = MagFilter::Nearest,
                                 .wrap_s = wrap,
                                 .wrap_t = wrap,
                                 .env = env,
                                 .env_color = random_color(random)};
                state.texture.min_filter = MinFilter::Nearest;
                const vec4 color = random_color(random);
                MeshData square{.primitive = Primitive::Quads};
                square.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
                square.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                square.colors.assign(4, color);
                Draw draw{.mesh = make_mesh(square)};
                draw.map.texture = make_texture(std::move(t));
                add(lists.emplace_back(), state, std::move(draw));
            }
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "texture formats and environments", tally);
    EXPECT_EQ(tally.compared, 36L * size * size);
    EXPECT_LE(tally.worst, 1);
}

}  // namespace
}  // namespace gw
