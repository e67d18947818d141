// docs/manual/pixels.md: the worked examples.
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

// [R13.5]
TEST(ManualPixels, OverlappingCopies) {
    Workbench bench(vgx(), 16, 4);
    bench.run(WritePixels{{4, 0, 4, 1}, Plane::Depth, {}, {1, 2, 3, 4}, 0});
    bench.run(Copy{Plane::Depth, {4, 0, 4, 1}, 5, 0});
    for (const auto& [x, depth] : {std::pair(4, 1u), {5, 1u}, {6, 2u}, {7, 3u}, {8, 4u}, {9, 0u}})
        EXPECT_EQ(bench.depth(x, 0), depth) << x;
    // Upwards and to the left, beyond the window. Pixels without a source stay.
    bench.run(Copy{Plane::Depth, {-2, -1, 12, 3}, -1, 0});
    for (const auto& [x, depth] : {std::pair(4, 0u), {5, 1u}, {6, 1u}, {7, 2u}, {8, 3u}, {9, 4u}})
        EXPECT_EQ(bench.depth(x, 1), depth) << x;
    EXPECT_EQ(bench.depth(4, 0), 1u);
}

// [R4.4] [R13.1] [R13.2] [R13.4]
TEST(ManualPixels, MasksAndScissorGuardEveryPlane) {
    Workbench bench(vgx(), 8, 8);
    bench.state.scissor = {true, {2, 2, 3, 3}};
    bench.state.color_mask = {false, true, true, true};
    bench.state.stencil.write_mask = 0x0F;
    bench.clear(all_planes, vec4(1), 1, 255);
    EXPECT_EQ(bench.take_counters().pixels, 4u * 9);
    EXPECT_EQ(bench.color(2, 2), (Rgba{0, 255, 255, 255}));
    EXPECT_EQ(bench.color(1, 2), (Rgba{}));
    EXPECT_EQ(bench.stencil(4, 4), 15);
    EXPECT_EQ(bench.stencil(5, 4), 0);
    EXPECT_EQ(bench.depth(3, 3), 16777215u);
}

// [R13.8] [R13.9]
TEST(ManualPixels, AccumulationByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto acc = [&] { return bench.accum(0, 0)[0]; };
    bench.write({0, 0, 1, 1}, {100, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Load, 1});
    bench.write({0, 0, 1, 1}, {255, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Accum, 0.5f});
    EXPECT_EQ(acc(), 228);
    bench.run(Accumulate{AccumOp::Mult, -1});
    EXPECT_EQ(acc(), -228);
    bench.run(Accumulate{AccumOp::Return, 1});
    EXPECT_EQ(bench.color(0, 0)[0], 0);
    bench.write({0, 0, 1, 1}, {253, 0, 0, 0});
    bench.run(Accumulate{AccumOp::Load, 0.5f});
    EXPECT_EQ(acc(), 126);
    bench.run(Accumulate{AccumOp::Add, 1});
    EXPECT_EQ(acc(), 381);
    EXPECT_EQ(bench.take_counters().accum_overflows, 0u);
}

// [R12.2] [R12.3] [R13.3]
TEST(ManualPixels, SpansAndRectanglesAreFragments) {
    Workbench bench(vgx(), 8, 8);
    bench.clear();
    bench.state.depth.test = true;
    bench.write({0, 0, 8, 8}, {1, 1, 1, 1}, 100);
    bench.run(WriteSpans{
        {{-2, 3, 6, 0, false}},
        {{2, 0, 0, 0}, {3, 0, 0, 0}, {4, 0, 0, 0}, {5, 0, 0, 0}, {6, 0, 0, 0}, {7, 0, 0, 0}},
        99});
    EXPECT_EQ(bench.color(0, 3)[0], 4);  // the first two lie outside
    EXPECT_EQ(bench.color(3, 3)[0], 7);
    EXPECT_EQ(bench.depth(3, 3), 99u);
    bench.write({0, 0, 8, 8}, {9, 9, 9, 9}, 100);  // Less: nowhere
    EXPECT_EQ(bench.color(5, 5)[0], 1);
}

/// Across whole blocks and tiles of the fast machine and across parts of them.
// [R13.7]
TEST(ManualPixels, PackedColorsAreWordsRLowest) {
    Workbench bench(vgx(), 80, 80);
    bench.clear(all_planes, vec4(1, 0, 0, 0));
    bench.write({3, 2, 70, 71}, {0x11, 0x22, 0x33, 0x44});
    bench.run(Read{.key = 1, .rect = {2, 1, 75, 74}, .packed = true});
    const Readback& read = bench.readbacks().at(1);
    EXPECT_TRUE(read.color.empty());
    ASSERT_EQ(read.values.size(), 75u * 74u);
    for (std::size_t i = 0; i < read.values.size(); ++i) {
        const std::size_t x = i % 75, y = i / 75;
        const bool written = x >= 1 && x < 71 && y >= 1 && y < 72;
        ASSERT_EQ(read.values[i], written ? 0x44332211u : 0x000000FFu) << x << ", " << y;
    }
}

TEST(ManualPixels, OnlyColorsOfEightBitsArePacked) {
    Workbench bench(vgx(), 8, 8), deep(ideal(), 8, 8);
    const auto read = [](Workbench& b, Plane plane) {
        return test::error_of([&] {
            b.run(Read{.plane = plane, .rect = {0, 0, 8, 8}, .packed = true});
        });
    };
    EXPECT_EQ(read(bench, Plane::Depth),
              "command 1 (Read): plane of packed pixels = 1; expected Color");
    EXPECT_EQ(read(deep, Plane::Color),
              "command 1 (Read): color_bits of packed pixels = 16; expected at most 8");
}

TEST(ManualPixels, AReadIntoGivenMemoryFillsItOnce) {
    for (const bool fast : {false, true}) {
        const auto machine = fast ? make_fast(vgx(), 8, 8) : make_reference(vgx(), 8, 8);
        CommandList list;
        list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(1, 0, 0, 0)});
        list.add(Read{.key = 3, .rect = {0, 0, 8, 8}, .packed = true});
        std::vector<std::uint32_t> given(64, 99);
        machine->read_into(3, given);
        machine->execute(list);
        EXPECT_EQ(given, std::vector<std::uint32_t>(64, 255));
        EXPECT_FALSE(machine->readbacks().contains(3));
        given.assign(64, 99);
        machine->execute(list);
        EXPECT_EQ(given, std::vector<std::uint32_t>(64, 99));
        EXPECT_EQ(machine->readbacks().at(3).values, CacheAlignedVector<std::uint32_t>(64, 255));
    }
}

TEST(ManualPixels, EveryPlaneOfWordsIsReadIntoGivenMemory) {
    for (const bool fast : {false, true}) {
        const auto machine = fast ? make_fast(vgx(), 8, 8) : make_reference(vgx(), 8, 8);
        CommandList list;
        list.add(Clear{.planes = all_planes, .depth = 1, .stencil = 7});
        list.add(Read{.key = 1, .plane = Plane::Depth, .rect = {1, 2, 3, 4}});
        list.add(Read{.key = 2, .plane = Plane::Stencil, .rect = {4, 4, 2, 2}});
        std::vector<std::uint32_t> depth(12), stencil(4);
        machine->read_into(1, depth);
        machine->read_into(2, stencil);
        machine->execute(list);
        EXPECT_EQ(depth, std::vector<std::uint32_t>(12, 0xFFFFFF));
        EXPECT_EQ(stencil, std::vector<std::uint32_t>(4, 7));
    }
}

TEST(ManualPixels, GivenMemoryFitsTheReadOrTheListIsRefused) {
    const auto machine = make_reference(vgx(), 8, 8);
    std::vector<std::uint32_t> given(63);
    CommandList list;
    list.add(Read{.key = 3, .plane = Plane::Depth, .rect = {0, 0, 8, 8}});
    machine->read_into(3, given);
    EXPECT_EQ(test::error_of([&] { machine->execute(list); }),
              "command 0 (Read): values of read_into = 63; expected width times height");
    list.commands[0] = Read{.key = 3, .plane = Plane::Accum, .rect = {0, 0, 8, 8}};
    machine->read_into(3, given);
    EXPECT_EQ(
        test::error_of([&] { machine->execute(list); }),
        "command 0 (Read): plane of read_into = accum; expected depth, stencil or packed color");
}

}  // namespace
}  // namespace gw
