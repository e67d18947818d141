// Rules of the reference manual that programs rely on: colours, depth, pixels, picking, curves.
#include "tests/irisgl/manual.h"

#include <utility>
#include <vector>

namespace gw::irisgl {

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

// Buffers

TEST_F(IrisGlManual, BothBuffersAreDrawnToIfBothAreOn) {
    doublebuffer();
    rgb();
    swapbuffers();
    clear();
    frontbuffer(TRUE);
    cpack(0xFF00FFFF);
    rectfi(2, 2, 5, 5);
    frontbuffer(FALSE);
    for (const long source : {SRC_FRONT, SRC_BACK}) {
        unsigned long pixel = 0;
        readsource(source);
        lrectread(3, 3, 3, 3, &pixel);
        EXPECT_EQ(pixel & 0xFFFFFF, 0x00FFFFu) << source;
    }
    readsource(SRC_AUTO);
}

// Pixels

TEST_F(IrisGlManual, AnIndexIsReadAtTheCharacterPosition) {
    mapcolor(9, 10, 200, 30);
    color(9);
    clear();
    cmov2i(5, 5);
    Colorindex index = 0;
    readpixels(1, &index);
    EXPECT_EQ(index, 9);
}

// Nearer than the middle: -1 of the signed range; the polygon is in the middle.
TEST_F(IrisGlManual, DepthsOfTheProgramHideWhatIsBehind) {
    rgb();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -1, 1);
    zbuffer(TRUE);
    czclear(0, getgdesc(GD_ZMAX));
    std::vector<unsigned long> near(4, (unsigned long)(getgdesc(GD_ZMIN)) & 0xFFFFFF);
    pixmode(PM_ZDATA, 1);
    lrectwrite(6, 6, 7, 7, near.data());
    pixmode(PM_ZDATA, 0);
    cpack(0xFF0000FF);
    square();
    zbuffer(FALSE);
    EXPECT_EQ(shown(6, 6), 0u);
    EXPECT_EQ(shown(9, 9), red);
}

// Picking

TEST_F(IrisGlManual, NamesBeforeSelectionBeginWithAnEmptyStack) {
    rgb();
    mmode(MVIEWING);
    ortho2(0, 10, 0, 10);
    short hits[50] = {};
    initnames();
    gselect(hits, 50);
    loadname(7);
    rectfi(2, 2, 4, 4);
    loadname(8);
    rectfi(20, 20, 30, 30);
    EXPECT_EQ(endselect(hits), 1);
    EXPECT_EQ(hits[0], 1);
    EXPECT_EQ(hits[1], 7);
    EXPECT_EQ(shown(3, 3), 0u);
}

TEST_F(IrisGlManual, ThePlaceOfAPixelIsThatOfAViewingObject) {
    makeobj(40);
    ortho2(0, 10, 0, 10);
    closeobj();
    float x = 0, y = 0;
    mapw2(40, 8, 8, &x, &y);
    delobj(40);
    EXPECT_NEAR(x, 5.3, 0.4);
    EXPECT_NEAR(y, 5.3, 0.4);
}

// Curves

TEST_F(IrisGlManual, ACurveHasBothItsEnds) {
    float bezier[4][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
    float line[4][3] = {{1, 3, 0}, {5, 3, 0}, {9, 3, 0}, {13, 3, 0}};
    defbasis(1, bezier);
    curvebasis(1);
    curveprecision(20);
    color(0);
    clear();
    color(5);
    crv(line);
    EXPECT_EQ(index_at(1, 3), 5);
    EXPECT_EQ(index_at(7, 3), 5);
    EXPECT_EQ(index_at(13, 3), 5);
    EXPECT_EQ(count_of(5), 13);
}

}  // namespace gw::irisgl
