// Reads into memory that the caller gives. docs/manual/pixels.md, "Pixels"
#include "tests/gw/workbench.h"

#include <random>

namespace gw {
namespace {

TEST(GivenMemory, AReadIntoGivenMemoryFillsItOnce) {
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

/// Across whole blocks, cut ones and blocks of one colour.
TEST(GivenMemory, MayHaveTheTopRowFirstAndBlueLowest) {
    for (const bool fast : {false, true}) {
        const auto machine = fast ? make_fast(vgx(), 80, 80) : make_reference(vgx(), 80, 80);
        const Rect part{3, 2, 70, 71}, read{2, 1, 75, 74};
        CommandList list;
        list.add(Clear{.planes = all_planes, .color = vec4(1, 0, 0, 0)});
        WritePixels write{.rect = part, .colors = {}};
        for (std::size_t i = 0; i < part.area(); ++i)
            write.colors.push_back({std::uint16_t(i % 251), 0x22, 0x33, 0x44});
        list.add(write);
        list.add(Read{.key = 1, .rect = read, .packed = true});
        list.add(Read{.key = 2, .rect = read, .packed = true});
        std::vector<std::uint32_t> plain(read.area()), turned(read.area());
        machine->read_into(1, plain);
        machine->read_into(2, turned, {.top_first = true, .blue_first = true});
        machine->execute(list);
        EXPECT_EQ(plain[pixel_index(72, 73, 75)], 0x000000FFu);
        for (int y = 0; y < read.height; ++y)
            for (int x = 0; x < read.width; ++x) {
                const std::uint32_t word = plain[pixel_index(x, y, read.width)];
                const std::uint32_t r = word & 0xFF, g = word & 0xFF00, b = word >> 16 & 0xFF;
                const std::size_t at = pixel_index(x, read.height - 1 - y, read.width);
                ASSERT_EQ(turned[at], b | g | r << 16) << x << ", " << y;
            }
    }
}

/// Colours of the window that change in parts from list to list, by clears and by pixels.
CommandList changed_part(std::mt19937& random) {
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    const float red = below(2) == 0 ? 0.f : 1.f;
    State state;
    state.scissor.test = true;
    state.scissor.box = {below(100), below(90), below(100), below(90)};
    CommandList list;
    list.add(SetState{state});
    list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(red, 0, 0, 0)});
    if (below(3) == 0)
        list.add(WritePixels{.rect = {below(100), below(90), 1, 1}, .colors = {{7, 8, 9, 10}}});
    return list;
}

TEST(GivenMemory, KnownPixelsNeedNotBeWrittenAgain) {
    for (const bool fast : {false, true}) {
        const auto machine = fast ? make_fast(vgx(), 100, 90) : make_reference(vgx(), 100, 90);
        std::mt19937 random(5);
        std::vector<std::uint32_t> kept(9000), fresh(9000);
        KnownPixels known;
        for (int i = 0; i < 200; ++i) {
            CommandList list = changed_part(random);
            list.add(Read{.key = 1, .rect = {0, 0, 100, 90}, .packed = true});
            list.add(Read{.key = 2, .rect = {0, 0, 100, 90}, .packed = true});
            machine->read_into(1, kept, {.top_first = true, .known = &known});
            machine->read_into(2, fresh, {.top_first = true});
            machine->execute(list);
            ASSERT_EQ(kept, fresh) << i;
        }
    }
}

TEST(GivenMemory, PixelsOfAPartAreNotKnown) {
    const auto machine = make_reference(vgx(), 8, 8);
    std::vector<std::uint32_t> given(56);
    KnownPixels known;
    CommandList list;
    list.add(Read{.key = 3, .rect = {0, 0, 7, 8}, .packed = true});
    machine->read_into(3, given, {.known = &known});
    EXPECT_EQ(
        test::error_of([&] { machine->execute(list); }),
        "command 0 (Read): known pixels of read_into = 56; expected those of the whole window");
}

TEST(GivenMemory, OnlyPackedColorsHaveAnotherLayout) {
    const auto machine = make_reference(vgx(), 8, 8);
    std::vector<std::uint32_t> given(64);
    CommandList list;
    list.add(Read{.key = 3, .plane = Plane::Depth, .rect = {0, 0, 8, 8}});
    machine->read_into(3, given, {.top_first = true});
    EXPECT_EQ(test::error_of([&] { machine->execute(list); }),
              "command 0 (Read): layout of read_into = depth; expected packed color");
}

TEST(GivenMemory, EveryPlaneOfWordsIsReadIntoGivenMemory) {
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

TEST(GivenMemory, FitsTheReadOrTheListIsRefused) {
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
