// Rules of the reference manual that programs rely on: light, textures, fragments.
#include "tests/irisgl/manual.h"

#include <cstdint>
#include <vector>

namespace gw::irisgl {

// Lighting

TEST_F(IrisGlManual, WhatIsNotDefinedBindsNothing) {
    rgb();
    mmode(MVIEWING);
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    float material[] = {DIFFUSE, 0, 0, 1, LMNULL}, none[] = {LMNULL};
    lmdef(DEFMATERIAL, 2049, 5, material);
    lmdef(DEFLIGHT, 6, 1, none);
    lmdef(DEFLMODEL, 6, 1, none);
    lmbind(MATERIAL, 2049);
    lmbind(LIGHT0, 6);
    lmbind(LMODEL, 6);
    const auto drawn = [] {
        cpack(0xFF0000FF);
        float up[3] = {0, 0, 1};
        n3f(up);
        square();
        return shown(7, 7);
    };
    EXPECT_GT(drawn() >> 16, 200u) << "lit: blue";
    lmbind(MATERIAL, 999);
    EXPECT_EQ(drawn(), red) << "not lit";
}

TEST_F(IrisGlManual, ShininessZeroTurnsHighlightsOff) {
    rgb();
    mmode(MVIEWING);
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    float material[] = {AMBIENT,  0, 0, 0, DIFFUSE,   0, 0,     0,
                        SPECULAR, 1, 1, 1, SHININESS, 0, LMNULL};
    float none[] = {LMNULL};
    lmdef(DEFMATERIAL, 3, 15, material);
    lmdef(DEFLIGHT, 3, 1, none);
    lmdef(DEFLMODEL, 3, 1, none);
    lmbind(MATERIAL, 3);
    lmbind(LIGHT0, 3);
    lmbind(LMODEL, 3);
    float up[3] = {0, 0, 1};
    n3f(up);
    square();
    EXPECT_EQ(shown(7, 7), 0u);
    lmbind(MATERIAL, 0);
}

TEST_F(IrisGlManual, AColourThatSetsTheMaterialStaysLit) {
    rgb();
    mmode(MVIEWING);
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    float material[] = {DIFFUSE, 1, 0, 0, LMNULL}, none[] = {LMNULL};
    lmdef(DEFMATERIAL, 8, 5, material);
    lmdef(DEFLIGHT, 8, 1, none);
    lmdef(DEFLMODEL, 8, 1, none);
    lmbind(MATERIAL, 8);
    lmbind(LIGHT0, 8);
    lmbind(LMODEL, 8);
    const auto lit = [] {
        float up[3] = {0, 0, 1};
        n3f(up);
        cpack(0xFF00FF00);
        square();
        return shown(7, 7);
    };
    EXPECT_EQ(lit(), green) << "a colour after the normal: not lit";
    lmcolor(LMC_DIFFUSE);
    EXPECT_GT(lit() >> 8 & 0xFF, 200u);
    EXPECT_LT(lit() & 0xFF, 60u);
    lmcolor(LMC_COLOR);
    lmbind(MATERIAL, 0);
}

// Textures

TEST_F(IrisGlManual, ATextureNeedsAnEnvironment) {
    rgb();
    unsigned long texels[4] = {0xFF00FF00, 0xFF00FF00, 0xFF00FF00, 0xFF00FF00};
    float modulate[] = {TV_MODULATE, TV_NULL}, decal[] = {TV_DECAL, TV_NULL};
    texdef2d(2, 4, 2, 2, texels, 0, nullptr);
    tevdef(2, 2, modulate);
    tevdef(3, 2, decal);
    const auto drawn = [](long environment) {
        tevbind(TV_ENV0, environment);
        cpack(0xFF0000FF);
        square();
        return shown(7, 7);
    };
    texbind(TX_TEXTURE_0, 2);
    EXPECT_EQ(drawn(0), red);
    EXPECT_EQ(drawn(2), 0u);
    EXPECT_EQ(drawn(3), green);
    EXPECT_EQ(drawn(0), red);
    tevbind(TV_ENV0, 3);
    texbind(TX_TEXTURE_0, 0);
    cpack(0xFF0000FF);
    square();
    EXPECT_EQ(shown(7, 7), red);
}

// The left half of 4 x 4 texels: 8 words.
TEST_F(IrisGlManual, APartOfATextureIsLoaded) {
    rgb();
    std::vector<unsigned long> greens(16, 0xFF00FF00), reds(8, 0xFF0000FF);
    float point[] = {TX_MINFILTER, TX_POINT, TX_MAGFILTER, TX_POINT, TX_NULL};
    float decal[] = {TV_DECAL, TV_NULL};
    tevdef(7, 2, decal);
    for (const bool is_bound : {false, true}) {
        texdef2d(7, 4, 4, 4, greens.data(), 5, point);
        tevbind(TV_ENV0, 7);
        if (is_bound) texbind(TX_TEXTURE_0, 7);
        subtexload(TX_TEXTURE_0, 7, 0, 0.5f, 0, 1, 8, reds.data(), 0);
        if (!is_bound) texbind(TX_TEXTURE_0, 7);
        square();
        EXPECT_EQ(shown(5, 7), red) << is_bound;
        EXPECT_EQ(shown(10, 7), green) << is_bound;
    }
    subtexload(TX_TEXTURE_0, 7, 0, 2, 0, 1, 8, reds.data(), 0);  // refused
    square();
    EXPECT_EQ(shown(10, 7), green);
    texbind(TX_TEXTURE_0, 0);
}

// Two rows of the window, the lower red, the upper blue, become the upper half of 4 x 4 green texels.
TEST_F(IrisGlManual, APartOfATextureIsLoadedFromTheFrameBuffer) {
    rgb();
    std::vector<unsigned long> greens(16, 0xFF00FF00);
    float point[] = {TX_MINFILTER, TX_POINT, TX_MAGFILTER, TX_POINT, TX_NULL};
    float decal[] = {TV_DECAL, TV_NULL};
    tevdef(8, 2, decal);
    texdef2d(8, 4, 4, 4, greens.data(), 5, point);
    tevbind(TV_ENV0, 8);
    texbind(TX_TEXTURE_0, 0);
    cpack(0xFF0000FF);
    rectfi(9, 3, 12, 3);
    cpack(0xFFFF0000);
    rectfi(9, 4, 12, 4);
    texbind(TX_TEXTURE_0, 8);
    fbsubtexload(9, 3, TX_TEXTURE_0, 8, 0, 1, 0.5f, 1, 0);
    square();
    EXPECT_EQ(shown(7, 5), green);
    EXPECT_EQ(shown(7, 9), red);
    EXPECT_EQ(shown(7, 11), 0xFF0000u);
    fbsubtexload(0, 0, TX_TEXTURE_0, 8, 0, 2, 0, 1, 0);  // refused
    square();
    EXPECT_EQ(shown(7, 5), green);
    texbind(TX_TEXTURE_0, 0);
}

// Without a number of properties they end with a null: 2 x 2 texels in point sampling, decal.
TEST_F(IrisGlManual, PropertiesOfTexturesEndWithANullIfNobodyCountsThem) {
    rgb();
    unsigned long texels[] = {0xFF0000FF, 0xFF00FF00, 0xFF0000FF, 0xFF00FF00};
    float point[] = {TX_FAST_DEFINE, TX_MINFILTER, TX_POINT, TX_MAGFILTER, TX_POINT, TX_NULL};
    float decal[] = {TV_COLOR, 0, 0, 0, 0, TV_DECAL, TV_NULL};
    texdef2d(9, 4, 2, 2, texels, 0, point);
    tevdef(9, 0, decal);
    tevbind(TV_ENV0, 9);
    texbind(TX_TEXTURE_0, 9);
    cpack(0xFFFF0000);
    square();
    for (int x = 4; x < 12; ++x) EXPECT_EQ(shown(x, 7), x < 8 ? red : green) << x;
    texbind(TX_TEXTURE_0, 0);
}

TEST_F(IrisGlManual, PixelsAreNotTextured) {
    rgb();
    unsigned long texels[4] = {0xFF00FF00, 0xFF00FF00, 0xFF00FF00, 0xFF00FF00};
    std::vector<unsigned long> reds(4, 0xFF0000FF);
    float decal[] = {TV_DECAL, TV_NULL};
    texdef2d(4, 4, 2, 2, texels, 0, nullptr);
    tevdef(4, 2, decal);
    texbind(TX_TEXTURE_0, 4);
    tevbind(TV_ENV0, 4);
    lrectwrite(4, 4, 5, 5, reds.data());
    texbind(TX_TEXTURE_0, 0);
    EXPECT_EQ(shown(4, 4), red);
}

// Fragments

TEST_F(IrisGlManual, WithoutTheZBufferAStencilsPassHolds) {
    rgb();
    sclear(0);
    zbuffer(FALSE);
    stencil(TRUE, 1, SF_ALWAYS, 1, ST_KEEP, ST_REPLACE, ST_KEEP);
    rectfi(2, 2, 5, 5);
    stencil(TRUE, 1, SF_EQUAL, 1, ST_KEEP, ST_KEEP, ST_KEEP);
    cpack(0xFF00FF00);
    rectfi(0, 0, 15, 15);
    stencil(FALSE, 0, SF_ALWAYS, 0, ST_KEEP, ST_KEEP, ST_KEEP);
    EXPECT_EQ(shown(3, 3), green);
    EXPECT_EQ(shown(9, 9), 0u);
}

TEST_F(IrisGlManual, DepthCueingIsBrightNearTheEye) {
    rgb();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    lRGBrange(0, 0, 0, 255, 255, 255, getgdesc(GD_ZMIN), getgdesc(GD_ZMAX));
    depthcue(TRUE);
    square(0.9f);
    const std::uint32_t near = shown(7, 7);
    square(-0.9f);
    depthcue(FALSE);
    EXPECT_GT(near & 0xFF, 230u);
    EXPECT_LT(shown(7, 7) & 0xFF, 25u);
}

TEST_F(IrisGlManual, HalfOfAColourComesBackFromTheAccumulationBuffer) {
    rgb(0xFF0000FF);
    acbuf(AC_CLEAR_ACCUMULATE, 0.5f);
    cpack(0);
    clear();
    acbuf(AC_RETURN, 1);
    EXPECT_NEAR(int(shown(3, 3)), 128, 1);
}

}  // namespace gw::irisgl
