// Logical operations, blend equations, stipples and smooth primitives through Mesa and us.
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

/// Noise that marks the stencil plane without a draw buffer, then noise where it did.
TEST_P(OpenGL, WithoutADrawBufferOnlyTheStencilPlaneChanges) {
    Random random(16);
    State unseen = window_state();
    unseen.draw_buffer = DrawBuffer::None;
    unseen.stencil = {.test = true, .zpass = StencilOp::Incr};
    unseen.alpha = {true, AlphaFunc::Greater, 0.499f};  // not near an 8-bit alpha
    State seen = window_state();
    seen.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 1};
    CommandList list;
    add(list, window_state(), noise(random));
    add(list, unseen, noise(random));
    list.add(Clear{.planes = mask_of(Plane::Color)});
    add(list, seen, noise(random));
    const Tally tally = compare_colors(execute({list}, size, size, coarse_opengl()),
                                       play({list}, coarse_opengl()).planes);
    report(GetParam(), "no draw buffer", tally);
    EXPECT_EQ(tally.compared, long(size) * size);
    EXPECT_EQ(tally.different, 0);
}

TEST_P(OpenGL, AccumulationClearedToAValueIsWithinOneUnit) {
    Random random(17);
    std::vector<CommandList> lists;
    for (int i = 0; i < 40; ++i) {
        CommandList& list = lists.emplace_back();
        add(list, window_state(),
            Clear{.planes = mask_of(Plane::Accum), .accum = 2.0f * random_color(random) - 1.0f});
        list.add(Accumulate{AccumOp::Return, 1});
    }
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "accumulation cleared to values", tally);
    EXPECT_EQ(tally.compared, 40L * size * size);
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

/// Coverage as alpha: white over 0, without blending.
State smooth_state() {
    State state = window_state();
    state.point_smooth = state.line_smooth = state.polygon_smooth = true;
    return state;
}

int alpha_at(const Planes& planes, std::size_t p) { return planes.color[p][3]; }

/// Mesa multiplies two fractions: how far the pixel reaches into the line along and across it.
TEST_P(OpenGL, SmoothLinesAreWithinASixteenth) {
    Random random(16);
    std::vector<CommandList> lists;
    const auto at = [&] { return float(random.between(8 * grid, (size - 8) * grid)) / grid; };
    for (int i = 0; i < 60; ++i) {
        State state = smooth_state();
        state.line_width = float(random.between(8, 64)) / 8;
        const float ax = at(), ay = at(), bx = at(), by = at();
        add(lists.emplace_back(), state,
            Draw{.mesh = make_mesh(
                     {.primitive = Primitive::Lines, .positions = {{ax, ay, 0}, {bx, by, 0}}})});
    }
    const auto ours = execute(lists, size, size, coarse_opengl()),
               theirs = play(lists, coarse_opengl()).planes;
    Tally tally;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int, int, std::size_t p) {
            const int a = alpha_at(ours[i], p), b = alpha_at(theirs[i], p);
            if (a != 0 || b != 0) tally.add(std::abs(a - b));
        });
    report(GetParam(), "smooth lines", tally);
    EXPECT_GT(tally.compared, 5000);
    EXPECT_LE(tally.worst, 16);
}

/// Mesa's smooth points have whole pixels, and its smooth polygons those of other polygons.
TEST_P(OpenGL, SmoothPointsAndPolygonsHoldMesasWholePixels) {
    Random random(17);
    std::vector<CommandList> lists;
    const auto at = [&] { return float(random.between(8 * grid, (size - 8) * grid)) / grid; };
    for (int i = 0; i < 40; ++i) {
        State state = smooth_state();
        state.point_size = float(random.between(24, 80)) / 8;
        const float x = at(), y = at();
        add(lists.emplace_back(), state,
            Draw{.mesh = make_mesh({.primitive = Primitive::Points, .positions = {{x, y, 0}}})});
        add(lists.emplace_back(), state,
            Draw{.mesh = make_mesh(
                     mesh_of(random_triangle(random), {0, 0, 0}, {vec4(1), vec4(1), vec4(1)}))});
    }
    const auto ours = execute(lists, size, size, coarse_opengl()),
               theirs = play(lists, coarse_opengl()).planes;
    Tally whole, partial;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int, int, std::size_t p) {
            const int a = alpha_at(ours[i], p), b = alpha_at(theirs[i], p);
            if (a == 255) whole.add(255 - b);
            if (b != 0) partial.add(255 - b);
        });
    report(GetParam(), "pixels wholly covered by points, polygons", whole);
    report(GetParam(), "Mesa's pixels of smooth points, polygons", partial);
    EXPECT_GT(whole.compared, 10000);
    EXPECT_EQ(whole.different, 0);
    EXPECT_EQ(partial.different, 0);
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
                    t.levels[0].rgba.edit().push_back(std::uint16_t(257 * random.between(0, 255)));
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

/// Mesa rounds the raster position to whole pixels.
RasterPosition random_corner(Random& random) {
    RasterPosition r;
    r.x = double(random.between(-8, size));
    r.y = double(random.between(-8, size));
    for (std::uint16_t& c : r.color) c = std::uint16_t(random.between(0, 255));
    return r;
}

/// Thirds: no edge meets a pixel's centre.
double random_zoom(Random& random) {
    const double zoom = double(float(random.between(1, 14)) / 3);
    return random.between(0, 2) == 0 ? -zoom : zoom;
}

/// Zoomed colours, copies of colours and bitmaps, over noise.
TEST_P(OpenGL, DrawnPixelsAgreeInEveryBit) {
    Random random(16);
    std::vector<CommandList> lists;
    for (int i = 0; i < 120; ++i) {
        DrawPixels d{.width = int(random.between(1, 20)),
                     .height = int(random.between(1, 20)),
                     .raster = random_corner(random)};
        State state = window_state();
        CommandList& list = lists.emplace_back();
        add(list, state, noise(random));
        if (i % 3 != 0) {
            d.zoom_x = random_zoom(random);
            d.zoom_y = random_zoom(random);
        }
        if (i % 3 == 0)
            for (std::size_t k = 0; k < d.bit_row() * std::size_t(d.height); ++k)
                d.bits.push_back(std::uint8_t(random.next()));
        if (i % 3 == 1)
            for (std::size_t k = 0; k < d.area(); ++k)
                d.colors.push_back({std::uint16_t(random.between(0, 255)), std::uint16_t(k & 255),
                                    std::uint16_t(k / 2), std::uint16_t(255 - k / 2)});
        if (i % 3 == 2)
            d.source = PixelSource{Plane::Color, int(random.between(0, size - 20)),
                                   int(random.between(0, size - 20))};
        state.scissor = {i % 4 == 0, {9, 5, 40, 44}};
        add(list, state, d);
    }
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "zoomed colours and copies, bitmaps", tally);
    EXPECT_EQ(tally.compared, 120L * size * size);
    EXPECT_EQ(tally.different, 0);
}

/// The raster position's texture coordinates, for all fragments of a rectangle.
TEST_P(OpenGL, DrawnPixelsAreTexturedWithinOneUnit) {
    Random random(17);
    std::vector<CommandList> lists;
    for (int i = 0; i < 60; ++i) {
        State state = window_state();
        state.texture = {.mag_filter = i % 2 ? MagFilter::Nearest : MagFilter::Linear};
        DrawPixels d{.width = 24, .height = 24, .raster = random_corner(random)};
        for (std::size_t k = 0; k < d.area(); ++k)
            d.colors.push_back({std::uint16_t(random.between(0, 255)), 255, 128, 77});
        d.raster.texcoord = {float(random.between(0, 31)) / 8, float(random.between(0, 31)) / 8, 0,
                             float(random.between(1, 4))};
        std::vector<std::uint8_t> texels;
        for (int k = 0; k < 64; ++k) texels.push_back(std::uint8_t(random.next()));
        d.map.texture = make_texture8("map", 4, 4, texels);
        add(lists.emplace_back(), state, d);
    }
    const Tally tally = compare_colors(execute(lists, size, size, coarse_opengl()),
                                       play(lists, coarse_opengl()).planes);
    report(GetParam(), "rectangles with texture", tally);
    EXPECT_LE(tally.worst, 1);
}

/// Stencil values, and depths that are tested and drawn in the raster colour.
TEST_P(OpenGL, DrawnDepthsAndStencilValuesAgree) {
    Random random(18);
    std::vector<CommandList> lists;
    for (int i = 0; i < 60; ++i) {
        CommandList& list = lists.emplace_back();
        State state = window_state();
        add(list, state, Clear{.planes = all_planes, .depth = 0.5, .stencil = 3});
        state.depth = {.test = true, .func = DepthFunc::Less};
        state.stencil.write_mask = 0x3C;
        DrawPixels d{.width = 16, .height = 12, .raster = random_corner(random)};
        if (i % 2 == 0)
            for (std::size_t k = 0; k < d.area(); ++k)
                d.stencils.push_back(std::uint32_t(random.between(0, 255)));
        else
            for (std::size_t k = 0; k < d.area(); ++k)
                d.depths.push_back(std::uint32_t(random.between(0, 65535)) << 8);
        add(list, state, d);
    }
    const auto ours = execute(lists, size, size, coarse_opengl()),
               theirs = play(lists, coarse_opengl()).planes;
    Tally colors = compare_colors(ours, theirs), depths, stencils;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int, int, std::size_t p) {
            depths.add(std::abs(double(ours[i].depth[p]) - double(theirs[i].depth[p])));
            stencils.add(std::abs(int(ours[i].stencil[p]) - int(theirs[i].stencil[p])));
        });
    report(GetParam(), "depth rectangles: colours", colors);
    report(GetParam(), "depth rectangles: depths", depths);
    report(GetParam(), "stencil rectangles", stencils);
    EXPECT_EQ(colors.different, 0);
    EXPECT_LE(depths.worst, 1);
    EXPECT_EQ(stencils.different, 0);
}

}  // namespace
}  // namespace gw
