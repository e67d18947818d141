// Planes, masks, patterns, maps and the program's memory of pixels: values by hand.
#include "tests/irisgl/support.h"

#include <cstdint>
#include <vector>

namespace gw::irisgl {

using IrisGlPlanes = IrisGl;

TEST_F(IrisGlPlanes, EveryBitOfALargePatternIsAPixelOfItsOwn) {
    std::vector<unsigned short> rows(256);
    std::uint32_t random = 1;
    for (auto& row : rows)
        row = static_cast<unsigned short>((random = random * 1664525 + 1013904223) >> 16);
    prefsize(80, 80);
    const long large = winopen("large");
    defpattern(3, 64, rows.data());
    const auto bit = [&](int x, int y) {
        return (rows[std::size_t(y % 64 * 4 + x % 64 / 16)] >> (15 - x % 16) & 1) != 0;
    };
    std::vector<short> pixels(6400);
    const auto check = [&](const char* what) {
        rectread(0, 0, 79, 79, pixels.data());
        int wrong = 0;
        for (int i = 0; i < 6400; ++i)
            wrong += (pixels[std::size_t(i)] == 5) != bit(i % 80, i / 80);
        EXPECT_EQ(wrong, 0) << what;
    };
    for (const bool clears : {true, false}) {
        setpattern(0);
        color(0);
        clear();
        setpattern(3);
        color(5);
        clears ? clear() : rectfi(0, 0, 79, 79);
        check(clears ? "clear" : "rectf");
    }
    setpattern(0);
    winclose(large);
}

TEST_F(IrisGlPlanes, CharactersHaveNoPattern) {
    unsigned short none[16] = {};
    color(0);
    clear();
    defpattern(4, 16, none);
    setpattern(4);
    color(5);
    cmov2i(1, 2);
    charstr(const_cast<char*>("I"));
    setpattern(0);
    EXPECT_GT(count_of(5), 10);
}

TEST_F(IrisGlPlanes, ZdrawPutsColoursIntoTheDepths) {
    unsigned long depths[4] = {};
    zclear();
    zdraw(TRUE);
    color(300);
    rectfi(0, 0, 3, 3);
    zdraw(FALSE);
    readsource(SRC_ZBUFFER);
    lrectread(2, 2, 3, 3, depths);
    readsource(SRC_AUTO);
    for (const unsigned long depth : depths) EXPECT_EQ(depth, 300u);
    EXPECT_EQ(index_at(2, 2), 300);
}

TEST_F(IrisGlPlanes, DepthsAreReadAndWrittenBack) {
    unsigned long depths[4] = {0x1234, 0xFFFFFFFF, 0x7FFFFF, 0xFF800000}, back[4] = {};
    zdraw(TRUE);
    frontbuffer(FALSE);
    lrectwrite(4, 4, 5, 5, depths);
    zdraw(FALSE);
    readsource(SRC_ZBUFFER);
    lrectread(4, 4, 5, 5, back);
    readsource(SRC_AUTO);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(std::uint32_t(back[i]), std::uint32_t(depths[i])) << i;
}

TEST_F(IrisGlPlanes, ComparedColoursKeepTheGreater) {
    color(9);
    clear();
    zbuffer(TRUE);
    zsource(ZSRC_COLOR);
    zfunction(ZF_GEQUAL);
    color(5);
    rectfi(0, 0, 3, 3);
    color(12);
    rectfi(6, 6, 9, 9);
    EXPECT_EQ(index_at(2, 2), 9);
    EXPECT_EQ(index_at(7, 7), 12);
    zfunction(ZF_LESS);
    color(5);
    rectfi(7, 7, 9, 9);
    EXPECT_EQ(index_at(7, 7), 5);
    EXPECT_EQ(index_at(6, 6), 12);
    zsource(ZSRC_DEPTH);
    zfunction(ZF_ALWAYS);
    color(3);
    rectfi(0, 0, 3, 3);
    EXPECT_EQ(index_at(2, 2), 3);
    zbuffer(FALSE);
}

// The lowest four bits are 15 on the line, 0 a pixel away; halfway 8 (7.5 to nearest).
TEST_F(IrisGlPlanes, ASmoothLineOfIndicesHasItsCoverageInFourBits) {
    color(0);
    clear();
    linesmooth(SML_ON);
    subpixel(TRUE);
    color(48);
    move2(2, 3);
    draw2(9, 3);
    move2(2, 8.5f);
    draw2(9, 8.5f);
    linesmooth(SML_OFF);
    EXPECT_EQ(index_at(5, 3), 63);
    EXPECT_EQ(index_at(5, 2), 0);
    EXPECT_EQ(index_at(5, 4), 0);
    EXPECT_EQ(index_at(5, 8), 56);
    EXPECT_EQ(index_at(5, 9), 56);
    EXPECT_EQ(index_at(12, 3), 0);
}

TEST_F(IrisGlPlanes, SixteenSmallMapsShowTheirOwnEntries) {
    EXPECT_EQ(getcmmode(), CMAPONE);
    EXPECT_EQ(getgdesc(GD_NMMAPS), 16);
    multimap();
    setmap(2);
    mapcolor(7, 10, 20, 30);
    setmap(3);
    mapcolor(7, 40, 50, 60);
    EXPECT_EQ(getmap(), 3);
    EXPECT_EQ(getcmmode(), CMAPMULTI);
    color(7);
    clear();
    EXPECT_EQ(shown(1, 1), 40u | 50u << 8 | 60u << 16);
    setmap(2);
    EXPECT_EQ(shown(1, 1), 10u | 20u << 8 | 30u << 16);
    setmap(16);
    EXPECT_EQ(getmap(), 2);
    onemap();
    EXPECT_EQ(shown(1, 1), 0xFFFFFFu);
}

TEST_F(IrisGlPlanes, PixelsObeyTheRgbWriteMaskBitByBit) {
    RGBmode();
    cpack(0xFF5A6B7C);
    clear();
    unsigned long words[4] = {0xFFC3A597, 0xFF000000, 0xFFFFFFFF, 0xFF123456};
    wmpack(0xFF0F00F0);
    lrectwrite(2, 2, 3, 3, words);
    rectzoom(2, 2);
    lrectwrite(8, 8, 9, 9, words);
    rectzoom(1, 1);
    wmpack(0xFFFFFFFF);
    const auto expected = [&](int i) {
        return (0x5A6B7Cu & ~0x0F00F0u) | (std::uint32_t(words[i]) & 0x0F00F0u);
    };
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(shown(2 + i % 2, 2 + i / 2), expected(i));
        EXPECT_EQ(shown(8 + i % 2 * 2, 9 + i / 2 * 2), expected(i));
    }
    EXPECT_EQ(shown(7, 8), 0x5A6B7Cu);
    EXPECT_EQ(shown(12, 8), 0x5A6B7Cu);
}

// Four pixels of 8 bits in a word, the leftmost highest; a row begins with a word.
TEST_F(IrisGlPlanes, PixelsOfTheProgramsMemoryMayHaveFewBits) {
    unsigned long bytes[2] = {0x01020304, 0x05060708}, back[2] = {};
    pixmode(PM_SIZE, 8);
    lrectwrite(0, 0, 2, 1, bytes);
    lrectread(0, 0, 2, 1, back);
    EXPECT_EQ(back[0], 0x01020300u);
    EXPECT_EQ(back[1], 0x05060700u);
    pixmode(PM_SIZE, 1);
    pixmode(PM_OFFSET, 4);
    pixmode(PM_EXPAND, 1);
    pixmode(PM_C0, 20);
    pixmode(PM_C1, 30);
    unsigned long bits[1] = {0xF5000000};  // after 4 bits: 0101
    lrectwrite(4, 4, 7, 4, bits);
    pixmode(PM_OFFSET, 0);
    pixmode(PM_EXPAND, 0);
    pixmode(PM_SIZE, 32);
    pixmode(PM_SHIFT, 4);
    pixmode(PM_ADD24, 3);
    unsigned long one[1] = {2};
    lrectwrite(9, 9, 9, 9, one);
    pixmode(PM_SHIFT, 0);
    pixmode(PM_ADD24, 0);
    for (int x = 0; x < 3; ++x) EXPECT_EQ(index_at(x, 1), 5 + x);
    for (int x = 0; x < 4; ++x) EXPECT_EQ(index_at(4 + x, 4), x % 2 == 0 ? 20 : 30) << x;
    EXPECT_EQ(index_at(9, 9), 2 * 16 + 3);
}

TEST_F(IrisGlPlanes, TheScreenBoxHoldsWhatWasDrawn) {
    long l = 0, r = 0, b = 0, t = 0;
    scrbox(SB_RESET);
    getscrbox(&l, &r, &b, &t);
    EXPECT_GT(l, r);
    scrbox(SB_TRACK);
    color(1);
    pnt2i(3, 4);
    pnt2i(9, 2);
    scrbox(SB_HOLD);
    pnt2i(12, 12);
    getscrbox(&l, &r, &b, &t);
    EXPECT_EQ(l, 3);
    EXPECT_EQ(r, 9);
    EXPECT_EQ(b, 2);
    EXPECT_EQ(t, 4);
}

TEST_F(IrisGlPlanes, OverlayPlanesAreReadByTheirSource) {
    overlay(4);
    drawmode(OVERDRAW);
    color(2);
    rectfi(0, 0, 3, 3);
    drawmode(NORMALDRAW);
    color(7);
    clear();
    readsource(SRC_OVER);
    EXPECT_EQ(index_at(2, 2), 2);
    readsource(SRC_AUTO);
    EXPECT_EQ(index_at(2, 2), 7);
    EXPECT_EQ(getdrawmode(), NORMALDRAW);
    drawmode(OVERDRAW);
    color(0);
    clear();
    drawmode(NORMALDRAW);
}

TEST_F(IrisGlPlanes, BlendingTakesConstantsLeastAndGreatest) {
    RGBmode();
    cpack(0xFF646464);
    clear();
    const auto drawn = [](unsigned long color, long source, long destination) {
        blendfunction(source, destination);
        cpack(color);
        rectfi(0, 0, 15, 15);
        blendfunction(BF_ONE, BF_ZERO);
        return shown(4, 4);
    };
    EXPECT_EQ(drawn(0xFF326496, BF_MAX, BF_ONE), 0x646496u);
    EXPECT_EQ(drawn(0xFF326496, BF_MIN, BF_ONE), 0x326496u);
    blendcolor(0, 1, 0, 1);
    EXPECT_EQ(drawn(0xFF808080, BF_CC, BF_MCC), 0x328096u);
}

TEST_F(IrisGlPlanes, GresetTurnsOffWhatWasOn) {
    RGBmode();
    blendfunction(BF_ONE, BF_ONE);
    afunction(255, AF_GREATER);
    greset();
    RGBmode();
    cpack(0xFF010101);
    clear();
    rectfi(0, 0, 3, 3);
    EXPECT_EQ(shown(2, 2), 0x010101u);
}

}  // namespace gw::irisgl
