// docs/manual/fragments.md, pixels.md, counters.md: two colour planes, draw buffer and read buffer.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

constexpr Rect one_pixel{0, 0, 1, 1};

/// Writes one colour to the pixels of a plane.
void put(Workbench& bench, DrawBuffer buffer, const Rect& rect, const Rgba& color) {
    const State state = bench.state;
    bench.state.draw_buffer = buffer;
    bench.write(rect, color);
    bench.state = state;
}

std::vector<vec3> square(float x0, float y0, float x1, float y1, float z = 0) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

// [R12.16]
TEST(ManualFragments, EachColourPlaneIsBlendedWithItself) {
    Workbench bench(opengl(), 1, 1);
    put(bench, DrawBuffer::Front, one_pixel, {10, 0, 0, 0});
    put(bench, DrawBuffer::Back, one_pixel, {20, 0, 0, 0});
    EXPECT_EQ(bench.color(0, 0)[0], 10);
    EXPECT_EQ(bench.back(0, 0)[0], 20);
    bench.state.draw_buffer = DrawBuffer::FrontAndBack;
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    bench.write(one_pixel, {5, 0, 0, 0});
    EXPECT_EQ(bench.color(0, 0)[0], 15);
    EXPECT_EQ(bench.back(0, 0)[0], 25);
    EXPECT_EQ(bench.stencil(0, 0), 1);
    EXPECT_EQ(bench.take_counters().written, 3u);
}

/// A triangle, a clear, spans and a return meet either plane, both and none.
// [R12.16] [R13.17]
TEST(ManualFragments, TheDrawBufferChoosesThePlanes) {
    for (const DrawBuffer buffer :
         {DrawBuffer::None, DrawBuffer::Front, DrawBuffer::Back, DrawBuffer::FrontAndBack}) {
        const bool front = buffer == DrawBuffer::Front || buffer == DrawBuffer::FrontAndBack,
                   back = buffer == DrawBuffer::Back || buffer == DrawBuffer::FrontAndBack;
        Workbench bench(opengl(), 32, 32);
        const auto expect = [&](int x, int y, const Rgba& color) {
            EXPECT_EQ(bench.color(x, y), front ? color : Rgba{}) << int(buffer);
            EXPECT_EQ(bench.back(x, y), back ? color : Rgba{}) << int(buffer);
        };
        bench.state.draw_buffer = buffer;
        bench.clear(mask_of(Plane::Color), {1, 0, 0, 0});
        expect(3, 3, {255, 0, 0, 0});
        bench.clear(mask_of(Plane::Depth));
        bench.state.depth = {.test = true, .func = DepthFunc::Less, .mask = true};
        bench.draw(test::mesh_data(Primitive::Quads, square(4, 4, 20, 20, 7),
                                   std::vector<vec4>(4, vec4(0, 1, 0, 1))));
        expect(9, 9, {0, 255, 0, 255});
        EXPECT_EQ(bench.depth(9, 9), 7u);
        bench.run(WriteSpans{{{0, 30, 9, 0, true}}, {{1, 2, 3, 4}}, 0});
        expect(8, 30, {1, 2, 3, 4});
        bench.run(Clear{.planes = mask_of(Plane::Accum), .accum = vec4(0, 0, 1, 0)});
        bench.state.scissor = {true, {2, 2, 20, 20}};
        bench.run(Accumulate{AccumOp::Return, 0.5f});
        expect(9, 9, {0, 0, 128, 0});
    }
}

// [R12.16] [R4.5] [R14.8]
TEST(ManualFragments, WithoutADrawBufferTestsStillRun) {
    Workbench bench(vgx(), 16, 16);
    bench.clear();
    bench.take_counters();
    bench.state.draw_buffer = DrawBuffer::None;
    bench.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    bench.state.depth.test = true;
    bench.draw(Primitive::Quads, square(0, 0, 16, 16, 5));
    EXPECT_EQ(bench.depth(3, 3), 5u);
    EXPECT_EQ(bench.stencil(3, 3), 1);
    EXPECT_EQ(bench.color(3, 3), Rgba{});
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.written, 256u);
    EXPECT_EQ(c.bytes, 256u * (2 + 3 + 3));
}

// [R13.17] [R13.18]
TEST(ManualPixels, CopiesBetweenColourPlanes) {
    Workbench bench(opengl(), 8, 8);
    put(bench, DrawBuffer::Front, one_pixel, {1, 0, 0, 0});
    put(bench, DrawBuffer::Back, one_pixel, {2, 0, 0, 0});
    bench.state.read_buffer = ReadBuffer::Back;
    bench.run(Copy{Plane::Color, one_pixel, 3, 0});
    EXPECT_EQ(bench.color(3, 0)[0], 2);
    EXPECT_EQ(bench.back(3, 0)[0], 0);
    bench.state.read_buffer = ReadBuffer::Front;
    bench.state.draw_buffer = DrawBuffer::FrontAndBack;
    bench.run(Copy{Plane::Color, {3, 0, 1, 1}, 4, 4});
    EXPECT_EQ(bench.color(4, 4)[0], 2);
    EXPECT_EQ(bench.back(4, 4)[0], 2);
    bench.take_counters();
    bench.state.color_mask = {false, false, false, false};
    bench.state.scissor = {true, {0, 0, 1, 1}};
    bench.run(SwapBuffers{});
    EXPECT_EQ(bench.color(0, 0)[0], 2);
    EXPECT_EQ(bench.back(0, 0)[0], 1);
    EXPECT_EQ(bench.color(3, 0)[0], 0);
    EXPECT_EQ(bench.back(3, 0)[0], 2);
    EXPECT_EQ(bench.take_counters(), Counters{});
}

// [R13.17]
TEST(ManualPixels, TheReadBufferIsRead) {
    Workbench bench(opengl(), 8, 8);
    bench.clear();
    put(bench, DrawBuffer::Front, {0, 0, 8, 8}, {10, 0, 0, 0});
    put(bench, DrawBuffer::Back, {0, 0, 8, 8}, {20, 0, 0, 0});
    bench.state.read_buffer = ReadBuffer::Back;
    bench.run(Read{.key = 1, .rect = {2, 2, 1, 1}});
    bench.run(Read{.key = 2, .rect = {2, 2, 1, 1}, .packed = true});
    bench.run(Accumulate{AccumOp::Load, 1});
    bench.run(CopyTexture{0, Plane::Color, {0, 0, 8, 8}});
    bench.state.read_buffer = ReadBuffer::Front;
    bench.run(Read{.key = 3, .rect = {2, 2, 1, 1}});
    bench.run(Accumulate{AccumOp::Accum, 2});
    EXPECT_EQ(bench.readbacks().at(1).color[0][0], 20);
    EXPECT_EQ(bench.readbacks().at(2).values[0], 20u);
    EXPECT_EQ(bench.readbacks().at(3).color[0][0], 10);
    EXPECT_EQ(bench.accum(5, 5)[0], 40 << 16);  // R13.19
    bench.state.texture.env = TexEnv::Replace;
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Quads, square(0, 0, 8, 8)))};
    draw.map.slot = 0;
    bench.draw(draw);
    EXPECT_EQ(bench.color(4, 4)[0], 20);
}

// [R14.7] [R14.8]
TEST(ManualCounters, ColoursWrittenToBothPlanesCountTwice) {
    Workbench bench(opengl(), 16, 16);
    bench.state.draw_buffer = DrawBuffer::FrontAndBack;
    const auto bytes = [&](Command command) {
        bench.take_counters();
        bench.run(std::move(command));
        const Counters c = bench.take_counters();
        EXPECT_EQ(c.pixels + c.fragments, 256u);
        return c.bytes / 256;
    };
    const auto pixels = [](Plane plane) {
        return WritePixels{{0, 0, 16, 16}, plane, std::vector<Rgba>(256), {}, 0};
    };
    EXPECT_EQ(bytes(Clear{.planes = mask_of(Plane::Color)}), 8u);
    EXPECT_EQ(bytes(Clear{.planes = mask_of(Plane::Depth)}), 3u);
    EXPECT_EQ(bytes(Accumulate{AccumOp::Load, 1}), 16u + 4);
    EXPECT_EQ(bytes(Accumulate{AccumOp::Return, 1}), 16u + 8);
    EXPECT_EQ(bytes(Copy{Plane::Color, {0, 0, 16, 16}, 0, 0}), 4u + 8);
    EXPECT_EQ(bytes(Copy{Plane::Depth, {0, 0, 16, 16}, 0, 0}), 6u);
    EXPECT_EQ(bytes(pixels(Plane::Color)), 8u);
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    EXPECT_EQ(bytes(pixels(Plane::Color)), 16u);
}

// [R14.9] [R14.10]
TEST(ManualCounters, TheBackPlaneHasADigest) {
    Workbench bench(opengl(), 70, 70);
    CommandList list;
    list.add(BeginPass{"both", planes_of(opengl())});
    list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(1, 0, 0, 1)});
    list.add(SwapBuffers{});
    bench.run(list);
    bench.compare();
    const PassReport pass = bench.machine().passes().at(0);
    Planes swapped = bench.planes();
    std::swap(swapped.color, swapped.back);
    EXPECT_EQ(pass.digests[std::size_t(Plane::Back)], digest(swapped, Plane::Color));
    EXPECT_EQ(pass.digests[std::size_t(Plane::Color)], digest(swapped, Plane::Back));
    EXPECT_NE(digest(swapped, Plane::Back), digest(swapped, Plane::Color));
}

/// Blocks of one colour are stored as one value: they keep it while the other plane is drawn to,
/// over exchanges, and where a plane was never drawn to before the first exchange.
// [R13.18]
TEST(ManualPixels, PlanesKeepTheirColoursOverExchanges) {
    for (const bool back_first : {false, true}) {
        Workbench bench(opengl(), 100, 70);
        bench.state.draw_buffer = back_first ? DrawBuffer::Back : DrawBuffer::Front;
        for (int i = 0; i < 4; ++i) {
            CommandList list;
            list.add(SetState{bench.state});
            list.add(Clear{.color = vec4(0.25f * float(i), 0, 0, 1)});
            std::get<Clear>(list.commands[1]).planes = mask_of(Plane::Color);
            list.add(Draw{.mesh = make_mesh(test::mesh_data(
                              Primitive::Quads, square(10.0f * float(i), 3, 60, 50),
                              std::vector<vec4>(4, vec4(0, 0.25f * float(i), 1, 1))))});
            list.add(SwapBuffers{});
            State other = bench.state;
            other.draw_buffer = back_first ? DrawBuffer::Front : DrawBuffer::Back;
            other.scissor = {true, {20, 20, 30, 11}};
            list.add(SetState{other});
            if (i > 0) list.add(std::get<Clear>(list.commands[1]));
            list.add(Read{.key = std::uint32_t(i), .rect = {0, 0, 100, 70}});
            bench.run(list);
            if (i % 2) bench.compare();
        }
    }
}

}  // namespace
}  // namespace gw
