#include "tests/irisgl/support.h"

namespace gw::irisgl {

using IrisGlColors = IrisGl;

TEST_F(IrisGlColors, EveryIndexOfTwelveBitsIsKept) {
    for (const int index : {0, 1, 7, 255, 256, 2748, 4095}) {
        color(Colorindex(index));
        clear();
        EXPECT_EQ(index_at(3, 5), index);
    }
}

TEST_F(IrisGlColors, TheMapIsAppliedWhenTheWindowIsShown) {
    mapcolor(300, 10, 20, 30);
    color(300);
    clear();
    EXPECT_EQ(shown(4, 4), 10u | 20u << 8 | 30u << 16);
    mapcolor(300, 1, 2, 3);
    EXPECT_EQ(shown(4, 4), 1u | 2u << 8 | 3u << 16);
}

TEST_F(IrisGlColors, TheWriteMaskKeepsEachBitOutsideIt) {
    for (const int mask : {0, 1, 0x0A5, 0x0FF, 0xF00, 0x3C3, 0xFFF}) {
        writemask(0xFFF);
        color(0x5A6);
        clear();
        writemask(Colorindex(mask));
        color(0xA3C);
        rectfi(2, 2, 9, 9);
        writemask(0xFFF);
        EXPECT_EQ(index_at(5, 5), (0x5A6 & ~mask) | (0xA3C & mask)) << mask;
        EXPECT_EQ(index_at(11, 5), 0x5A6);
    }
}

TEST_F(IrisGlColors, ClearAndPixelsObeyTheWriteMask) {
    color(0x0F0);
    clear();
    writemask(0x00F);
    color(0xFFF);
    clear();
    EXPECT_EQ(index_at(1, 1), 0x0FF);
    short pixel = 0x003;
    rectwrite(2, 2, 2, 2, &pixel);
    EXPECT_EQ(index_at(2, 2), 0x0F3);
}

// Linear between 100 and 400 over 16 pixels: at pixel x the edge values stand at -0.5 and 15.5.
TEST_F(IrisGlColors, ShadedIndicesAreTheNearestOfEachPixel) {
    color(0);
    clear();
    const float corners[4][2] = {{-0.5f, -0.5f}, {15.5f, -0.5f}, {15.5f, 15.5f}, {-0.5f, 15.5f}};
    const Colorindex indices[4] = {100, 420, 420, 100};
    subpixel(TRUE);
    splf2(4, const_cast<float(*)[2]>(corners), const_cast<Colorindex*>(indices));
    for (int x = 0; x < 16; ++x) EXPECT_EQ(index_at(x, 7), 100 + 10 + 20 * x) << x;
}

TEST_F(IrisGlColors, RgbModeShowsColoursWithoutTheMap) {
    RGBmode();
    gconfig();
    cpack(0xFF0A141E);
    clear();
    EXPECT_EQ(shown(8, 8), 0x0A141Eu);
}

TEST_F(IrisGlColors, WordsOutsideTheirRangeChangeNothing) {
    shademodel(77);
    EXPECT_EQ(getsm(), GOURAUD);
    mapcolor(5000, 1, 2, 3);
    popattributes();
    setpattern(9);
    EXPECT_EQ(getpattern(), 0);
}

TEST_F(IrisGlColors, OverlayPlanesCoverThePictureWhereTheyAreNotZero) {
    color(RED);
    clear();
    drawmode(OVERDRAW);
    mapcolor(1, 9, 8, 7);
    color(0);
    clear();
    color(1);
    rectfi(0, 0, 3, 3);
    drawmode(NORMALDRAW);
    EXPECT_EQ(shown(2, 2), 9u | 8u << 8 | 7u << 16);
    EXPECT_EQ(shown(9, 9), 0xFFu);
    EXPECT_EQ(index_at(2, 2), RED);
}

TEST_F(IrisGlColors, TheRgbWriteMaskKeepsEachBitOutsideIt) {
    RGBmode();
    for (const unsigned mask : {0u, 0xFFu, 0x0F00F0u, 0x81FF3Cu, 0xFFFFFFu}) {
        wmpack(0xFFFFFFFF);
        cpack(0xFF5A6B7C);
        clear();
        wmpack(0xFF000000 | mask);
        cpack(0xFFC3A597);
        rectfi(2, 2, 9, 9);
        EXPECT_EQ(shown(5, 5), (0x5A6B7Cu & ~mask) | (0xC3A597u & mask)) << mask;
        EXPECT_EQ(shown(11, 5), 0x5A6B7Cu);
        clear();
        EXPECT_EQ(shown(11, 5), (0x5A6B7Cu & ~mask) | (0xC3A597u & mask)) << mask;
    }
    wmpack(0xFFFFFFFF);
}

// The bits of what is drawn without a mask, among those of the background.
TEST_F(IrisGlColors, TheRgbWriteMaskHoldsForLightTextureAndBlending) {
    RGBmode();
    subpixel(TRUE);
    const auto picture = [&](unsigned mask, const auto& draw) {
        wmpack(0xFFFFFFFF);
        blendfunction(BF_ONE, BF_ZERO);
        cpack(0xFF5A6B7C);
        clear();
        wmpack(0xFF000000 | mask);
        draw();
        return shown(5, 5);
    };
    const auto shade = [] {
        shademodel(GOURAUD);
        bgnpolygon();
        const unsigned long colors[4] = {0xFF0000FF, 0xFF00FF37, 0xFFC3A597, 0xFFFFFFFF};
        const float corners[4][2] = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
        for (int i = 0; i < 4; ++i) {
            cpack(colors[i]);
            v2f(const_cast<float*>(corners[i]));
        }
        endpolygon();
    };
    const auto blend = [&] {
        blendfunction(BF_ONE, BF_ONE);
        shade();
    };
    const auto combine = [&] {
        logicop(LO_XOR);
        shade();
        logicop(LO_SRC);
    };
    const unsigned mask = 0x81F03C;
    const auto expect_bits = [&](const auto& draw) {
        const std::uint32_t whole = picture(0xFFFFFF, draw);
        EXPECT_NE(whole, 0x5A6B7Cu);
        EXPECT_EQ(picture(mask, draw), (0x5A6B7Cu & ~mask) | (whole & mask));
    };
    expect_bits(shade);
    expect_bits(blend);
    expect_bits(combine);
    wmpack(0xFFFFFFFF);
}

TEST_F(IrisGlColors, TheWriteMaskHoldsForShadedIndicesAndLogicalOperations) {
    const auto index_after = [&](unsigned mask, long op) {
        writemask(0xFFF);
        color(0x5A6);
        clear();
        writemask(Colorindex(mask));
        logicop(op);
        const float corners[4][2] = {
            {-0.5f, -0.5f}, {15.5f, -0.5f}, {15.5f, 15.5f}, {-0.5f, 15.5f}};
        const Colorindex indices[4] = {100, 420, 420, 100};
        splf2(4, const_cast<float(*)[2]>(corners), const_cast<Colorindex*>(indices));
        logicop(LO_SRC);
        return index_at(5, 7);
    };
    subpixel(TRUE);
    EXPECT_EQ(index_after(0xFFF, LO_SRC), 210);
    EXPECT_EQ(index_after(0x3C3, LO_SRC), (0x5A6 & ~0x3C3) | (210 & 0x3C3));
    EXPECT_EQ(index_after(0x3C3, LO_XOR), (0x5A6 & ~0x3C3) | ((0x5A6 ^ 210) & 0x3C3));
    writemask(0xFFF);
}

// [R18.7] From the top: pop-up, overlay, picture, underlay.
TEST_F(IrisGlColors, EachKindOfPlanesHasItsPlaceInTheStack) {
    color(0);
    clear();
    color(RED);
    rectfi(0, 0, 11, 0);
    const auto fill = [](long mode, int right, short r) {
        drawmode(mode);
        mapcolor(2, r, 0, 1);
        color(0);
        clear();
        color(2);
        rectfi(0, 0, Icoord(right), 0);
        drawmode(NORMALDRAW);
    };
    underlay(2);
    fill(UNDERDRAW, 15, 50);
    fill(OVERDRAW, 7, 60);
    fill(PUPDRAW, 3, 70);
    EXPECT_EQ(shown(3, 0), 70u | 1u << 16);
    EXPECT_EQ(shown(7, 0), 60u | 1u << 16);
    EXPECT_EQ(shown(11, 0), 0xFFu);
    EXPECT_EQ(shown(15, 0), 50u | 1u << 16);
    EXPECT_EQ(shown(15, 1), 0u);
    drawmode(PUPDRAW);
    EXPECT_EQ(getplanes(), 2);
    drawmode(UNDERDRAW);
    EXPECT_EQ(getplanes(), 2);
    drawmode(NORMALDRAW);
    EXPECT_EQ(getplanes(), 12);
    RGBmode();
    EXPECT_EQ(getplanes(), 24);
}

}  // namespace gw::irisgl
