// Rules of the reference manual that programs rely on, chapter by chapter.
#include "tests/irisgl/support.h"

#include <algorithm>
#include <vector>

namespace gw::irisgl {
namespace {

class IrisGlManual : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        mmode(MSINGLE);
        ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    }
    void TearDown() override {
        glcompat(GLC_OLDPOLYGON, 1);
        IrisGl::TearDown();
    }
    static void rgb(std::uint32_t background = 0) {
        RGBmode();
        gconfig();
        cpack(background);
        clear();
    }
    /// A square of 8 x 8 pixels from (4, 4) on, by bgnpolygon, with texture coordinates.
    static void square(float z = 0) {
        const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        bgnpolygon();
        for (const auto& c : corners) {
            float t[2] = {c[0], c[1]}, v[3] = {4 + 8 * c[0], 4 + 8 * c[1], z};
            t2f(t);
            v3f(v);
        }
        endpolygon();
    }
};

constexpr std::uint32_t red = 0x0000FF, green = 0x00FF00, blue = 0xFF0000;

}  // namespace

// Drawing

TEST_F(IrisGlManual, OldPolygonsOwnTheirEdges) {
    const auto corners_drawn = [](const auto& draw) {
        color(0);
        clear();
        color(5);
        draw();
        return (index_at(3, 3) == 5) + (index_at(9, 3) == 5) + (index_at(9, 9) == 5) +
               (index_at(3, 9) == 5) - (index_at(10, 9) == 5) - (index_at(9, 10) == 5);
    };
    const auto polygon = [] {
        long p[4][2] = {{3, 3}, {9, 3}, {9, 9}, {3, 9}};
        polf2i(4, p);
    };
    const auto moved = [] {
        pmv2i(3, 3);
        pdr2i(9, 3);
        pdr2i(9, 9);
        pdr2i(3, 9);
        pclos();
    };
    const auto begun = [] {
        bgnpolygon();
        for (const auto& [x, y] : {std::pair{3L, 3L}, {9L, 3L}, {9L, 9L}, {3L, 9L}}) {
            long v[2] = {x, y};
            v2i(v);
        }
        endpolygon();
    };
    const auto rectangle = [] { rectfi(3, 3, 9, 9); };
    EXPECT_EQ(corners_drawn(polygon), 4);
    EXPECT_EQ(corners_drawn(moved), 4);
    EXPECT_EQ(corners_drawn(rectangle), 4);
    EXPECT_EQ(corners_drawn(begun), 1) << "by centres";
    glcompat(GLC_OLDPOLYGON, 0);
    EXPECT_EQ(corners_drawn(polygon), 1);
    EXPECT_EQ(corners_drawn(rectangle), 1);
}

// Clockwise corners; a cross of two lines would draw its edges.
TEST_F(IrisGlManual, BackFacesHaveNoEdgesEither) {
    color(0);
    clear();
    color(5);
    backface(TRUE);
    long p[4][2] = {{3, 3}, {3, 9}, {9, 9}, {9, 3}};
    polf2i(4, p);
    backface(FALSE);
    EXPECT_EQ(count_of(5), 0);
}

// Blended once: each pixel of red over blue at half alpha has the same colour.
TEST_F(IrisGlManual, NoPixelOfAnOldPolygonIsBlendedTwice) {
    rgb(0xFFFF0000);
    blendfunction(BF_SA, BF_MSA);
    cpack(0x800000FF);
    long p[4][2] = {{3, 3}, {9, 3}, {9, 9}, {3, 9}};
    polf2i(4, p);
    blendfunction(BF_ONE, BF_ZERO);
    for (int x = 3; x < 9; ++x) EXPECT_EQ(shown(x, 5), shown(5, 5));
}

TEST_F(IrisGlManual, ANotchOfAConcavePolygonStaysEmpty) {
    color(0);
    clear();
    color(5);
    concave(TRUE);
    float u[8][2] = {{1, 1}, {13, 1}, {13, 13}, {10, 13}, {10, 6}, {4, 6}, {4, 13}, {1, 13}};
    polf2(8, u);
    concave(FALSE);
    EXPECT_EQ(index_at(7, 10), 0);
    EXPECT_EQ(index_at(2, 10), 5);
    EXPECT_EQ(index_at(7, 3), 5);
}

// Colours

TEST_F(IrisGlManual, GconfigSetsTheColourToZero) {
    RGBmode();
    cpack(0xFF0000FF);
    gconfig();
    short r = 1, g = 1, b = 1;
    gRGBcolor(&r, &g, &b);
    EXPECT_EQ(r + g + b, 0);
    EXPECT_EQ(getbuffer(), 0) << "a single buffer";
}

TEST_F(IrisGlManual, TheLaterOfBlendingAndLogicHolds) {
    rgb(0xFF0000FF);
    logicop(LO_XOR);
    blendfunction(BF_SA, BF_MSA);
    cpack(0xFF0000FF);
    rectfi(0, 0, 4, 4);
    EXPECT_EQ(shown(2, 2), red) << "no exclusive or";
    logicop(LO_XOR);
    rectfi(6, 6, 9, 9);
    logicop(LO_SRC);
    EXPECT_EQ(shown(7, 7), 0u) << "no blending";
}

TEST_F(IrisGlManual, ABlendsSecondFactorTwoIsTheSource) {
    rgb(0xFFFFFFFF);
    blendfunction(BF_ZERO, BF_SC);
    cpack(0xFF0000FF);
    rectfi(0, 0, 4, 4);
    blendfunction(BF_ONE, BF_ZERO);
    EXPECT_EQ(shown(2, 2), red);
}

// Depth

TEST_F(IrisGlManual, CzclearKeepsTheColourAndIgnoresTheMask) {
    rgb();
    cpack(0xFF0000FF);
    czclear(0xFFFF0000, getgdesc(GD_ZMAX));
    EXPECT_EQ(shown(2, 2), blue);
    square();
    EXPECT_EQ(shown(7, 7), red);
    wmpack(0);
    czclear(0xFF00FF00, getgdesc(GD_ZMAX));
    wmpack(0xFFFFFFFF);
    EXPECT_EQ(shown(2, 2), green);
}

TEST_F(IrisGlManual, ZclearClearsToTheFarEndWhateverCameBefore) {
    rgb();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    zbuffer(TRUE);
    czclear(0, getgdesc(GD_ZMIN));
    zclear();
    cpack(0xFF0000FF);
    square(-0.5f);
    EXPECT_EQ(shown(7, 7), red);
    cpack(0xFF00FF00);
    square(-0.5f);
    EXPECT_EQ(shown(7, 7), green) << "equal depths pass";
    pushattributes();
    zbuffer(FALSE);
    popattributes();
    EXPECT_FALSE(getzbuffer()) << "no attribute";
}

TEST_F(IrisGlManual, APerspectiveMayBeginAtTheEye) {
    rgb();
    mmode(MVIEWING);
    perspective(900, 1, 0, 100);
    cpack(0xFF00FF00);
    bgnpolygon();
    for (const auto& [x, y] :
         {std::pair{-5.0f, -5.0f}, {5.0f, -5.0f}, {5.0f, 5.0f}, {-5.0f, 5.0f}}) {
        float v[3] = {x, y, -10};
        v3f(v);
    }
    endpolygon();
    EXPECT_EQ(shown(8, 8), green);
}

TEST_F(IrisGlManual, MsingleBeginsWithTheIdentity) {
    mmode(MVIEWING);
    translate(5, 0, 0);
    mmode(MSINGLE);
    float m[4][4];
    getmatrix(m);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) EXPECT_EQ(m[i][j], i == j ? 1 : 0);
}

TEST_F(IrisGlManual, TheZBufferIsOffInTheWindowIfItIsInTheOverlay) {
    rgb();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    zbuffer(TRUE);
    zclear();
    drawmode(OVERDRAW);
    zbuffer(FALSE);
    drawmode(NORMALDRAW);
    cpack(0xFF0000FF);
    square(0.5f);
    cpack(0xFF00FF00);
    square(-0.5f);
    EXPECT_EQ(shown(7, 7), green);
}

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

}  // namespace gw::irisgl
