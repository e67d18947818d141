// Blending, textures, fog, stencil, accumulation, clip planes, pixels, patches: values by hand.
#include "tests/irisgl/support.h"

#include <vector>

namespace gw::irisgl {

class IrisGlFragments : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        RGBmode();
        cpack(0xFF000000);
        clear();
    }
    static void all() { rectfi(0, 0, 15, 15); }
};

// 255 x 0.2 + 100 x (1 - 0.2) with alpha 51 of 255.
TEST_F(IrisGlFragments, BlendingWeighsByTheSourcesAlpha) {
    cpack(0xFF646464);
    clear();
    blendfunction(BF_SA, BF_MSA);
    cpack(0x33FF0000);
    all();
    EXPECT_EQ(shown(4, 4), 80u | 80u << 8 | 131u << 16);
    blendfunction(BF_ONE, BF_ONE);
    cpack(0x00010203);
    all();
    EXPECT_EQ(shown(4, 4), 83u | 82u << 8 | 132u << 16);
    blendfunction(BF_ONE, BF_ZERO);
    all();
    EXPECT_EQ(shown(4, 4), 0x010203u);
}

TEST_F(IrisGlFragments, TheAlphaFunctionComparesWithItsReference) {
    afunction(128, AF_GREATER);
    cpack(0x80FFFFFF);
    all();
    EXPECT_EQ(shown(4, 4), 0u);
    cpack(0x81FFFFFF);
    all();
    EXPECT_EQ(shown(4, 4), 0xFFFFFFu);
    afunction(0, AF_ALWAYS);
}

TEST_F(IrisGlFragments, LogicalOperationsCombineTheBits) {
    cpack(0xFF0F0F0F);
    clear();
    logicop(LO_XOR);
    cpack(0xFF00FF3C);
    all();
    logicop(LO_SRC);
    EXPECT_EQ(shown(4, 4), 0x0FF033u);
}

TEST_F(IrisGlFragments, TheStencilKeepsDrawingInsideItsShape) {
    sclear(0);
    stencil(TRUE, 1, SF_ALWAYS, 0xFF, ST_REPLACE, ST_REPLACE, ST_REPLACE);
    cpack(0xFF000001);
    rectfi(2, 2, 5, 5);
    stencil(TRUE, 1, SF_EQUAL, 0xFF, ST_KEEP, ST_KEEP, ST_KEEP);
    cpack(0xFFFFFFFF);
    all();
    stencil(FALSE, 0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(shown(i, 3), i >= 2 && i <= 5 ? 0xFFFFFFu : 0u) << i;
}

TEST_F(IrisGlFragments, TheAccumulationBufferAddsPictures) {
    acbuf(AC_CLEAR, 0);
    cpack(0xFF640000);
    clear();
    acbuf(AC_ACCUMULATE, 0.5f);
    cpack(0xFF0000C8);
    clear();
    acbuf(AC_ACCUMULATE, 0.5f);
    acbuf(AC_RETURN, 1);
    EXPECT_EQ(shown(4, 4), 100u | 50u << 16);
    acbuf(AC_CLEAR_ACCUMULATE, 1);
    acbuf(AC_MULT, 0.5f);
    acbuf(AC_RETURN, 1);
    EXPECT_EQ(shown(4, 4), 50u | 25u << 16);
}

// The plane keeps x >= 8: the pixels whose centres are at 8 and above.
TEST_F(IrisGlFragments, AClipPlaneKeepsItsPositiveSide) {
    const float plane[4] = {1, 0, 0, -7.75f};
    mmode(MVIEWING);
    ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    clipplane(0, CP_DEFINE, const_cast<float*>(plane));
    clipplane(0, CP_ON, nullptr);
    cpack(0xFFFFFFFF);
    const float v[4][2] = {{-0.5f, -0.5f}, {15.5f, -0.5f}, {15.5f, 15.5f}, {-0.5f, 15.5f}};
    polf2(4, const_cast<float(*)[2]>(v));
    clipplane(0, CP_OFF, nullptr);
    for (int x = 0; x < 16; ++x) EXPECT_EQ(shown(x, 3), x >= 8 ? 0xFFFFFFu : 0u) << x;
}

// Linear fog from 2 to 6: at depth 3 a quarter of the fog.
TEST_F(IrisGlFragments, LinearFogMixesByTheDistance) {
    mmode(MVIEWING);
    ortho(-1, 1, -1, 1, 0, 10);
    const float fog[5] = {2, 6, 0, 0, 1};
    fogvertex(FG_VTX_LIN, const_cast<float*>(fog));
    fogvertex(FG_ON, const_cast<float*>(fog));
    cpack(0xFF0000FF);
    const float v[4][3] = {{-1, -1, -3}, {1, -1, -3}, {1, 1, -3}, {-1, 1, -3}};
    polf(4, const_cast<float(*)[3]>(v));
    fogvertex(FG_OFF, const_cast<float*>(fog));
    EXPECT_EQ(shown(8, 8), 191u | 64u << 16);
}

// 2 x 2 texels over 16 x 16 pixels without a filter; modulated by half of the colour.
TEST_F(IrisGlFragments, TexelsModulateTheColour) {
    const unsigned long image[4] = {0xFF0000FF, 0xFF00FF00, 0xFFFF0000, 0xFFFFFFFF};  // ABGR
    const float props[] = {TX_MINFILTER, TX_POINT, TX_MAGFILTER, TX_POINT, TX_NULL};
    texdef2d(1, 4, 2, 2, const_cast<unsigned long*>(image), 5, const_cast<float*>(props));
    const float environment[] = {TV_MODULATE, TV_NULL};
    tevdef(1, 2, const_cast<float*>(environment));
    tevbind(TV_ENV0, 1);
    texbind(TX_TEXTURE_0, 1);
    cpack(0xFF333333);
    const float v[4][2] = {{-0.5f, -0.5f}, {15.5f, -0.5f}, {15.5f, 15.5f}, {-0.5f, 15.5f}};
    const float t[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    bgnpolygon();
    for (int i = 0; i < 4; ++i) {
        t2f(const_cast<float*>(t[i]));
        v2f(const_cast<float*>(v[i]));
    }
    endpolygon();
    texbind(TX_TEXTURE_0, 0);
    EXPECT_EQ(shown(3, 3), 0x000033u);
    EXPECT_EQ(shown(12, 3), 0x003300u);
    EXPECT_EQ(shown(3, 12), 0x330000u);
    EXPECT_EQ(shown(12, 12), 0x333333u);
}

TEST_F(IrisGlFragments, RectanglesOfPixelsAreWrittenCopiedZoomedAndRead) {
    unsigned long out[6] = {},
                  in[6] = {0xFF000001, 0xFF000002, 0xFF000003, 0xFF000004, 0xFF000005, 0xFF000006};
    lrectwrite(1, 1, 3, 2, in);
    EXPECT_EQ(lrectread(1, 1, 3, 2, out), 6);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(out[i], in[i]);
    EXPECT_EQ(shown(3, 2), 6u);
    rectcopy(1, 1, 3, 2, 5, 6);
    EXPECT_EQ(shown(5, 6), 1u);
    EXPECT_EQ(shown(7, 7), 6u);
    rectzoom(2, 2);
    rectcopy(1, 1, 3, 2, 8, 10);
    rectzoom(1, 1);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x)
            EXPECT_EQ(shown(8 + x, 10 + y), std::uint32_t(1 + x / 2 + y / 2 * 3)) << x << ' ' << y;
    EXPECT_EQ(shown(14, 10), 0u);
}

TEST_F(IrisGlFragments, PixmodeTurnsRowsAndColumns) {
    unsigned long in[4] = {0xFF000001, 0xFF000002, 0xFF000003, 0xFF000004};
    pixmode(PM_TTOB, 1);
    lrectwrite(0, 0, 1, 1, in);
    pixmode(PM_TTOB, 0);
    EXPECT_EQ(shown(0, 1), 1u);
    EXPECT_EQ(shown(1, 0), 4u);
    pixmode(PM_RTOL, 1);
    lrectwrite(0, 0, 1, 1, in);
    pixmode(PM_RTOL, 0);
    EXPECT_EQ(shown(1, 0), 1u);
    EXPECT_EQ(shown(0, 1), 4u);
}

// The near end has the high index; a quarter of the way has a quarter of the range less.
TEST_F(IrisGlFragments, DepthCueingChoosesIndicesByDepth) {
    cmode();
    color(0);
    clear();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, 0, 4);
    lsetdepth(0, 0x7fffff);
    lshaderange(100, 300, 0, 0x7fffff);
    depthcue(TRUE);
    for (int z = 0; z <= 4; ++z) pnt(Coord(z), 2, Coord(-z));
    depthcue(FALSE);
    for (int z = 0; z <= 4; ++z) EXPECT_EQ(index_at(z, 2), 300 - 50 * z) << z;
}

// Z from near to far in 4 units: of a range from 0, and of the same range mapped to all depths.
TEST_F(IrisGlFragments, RangesOfDepthsCanBeThoseOfAnyMachine) {
    cmode();
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, 0, 4);
    const auto depth_at = [](float z) {
        zclear();
        zbuffer(TRUE);
        pnt(3, 3, -z);
        zbuffer(FALSE);
        readsource(SRC_ZBUFFER);
        unsigned long depth = 0;
        lrectread(3, 3, 3, 3, &depth);
        readsource(SRC_AUTO);
        return std::int32_t(std::uint32_t(depth));
    };
    lsetdepth(0, 0x7fffff);
    EXPECT_EQ(depth_at(0), 0);
    EXPECT_NEAR(depth_at(2), 0x400000, 1);
    glcompat(GLC_ZRANGEMAP, 1);
    EXPECT_EQ(depth_at(0), -0x800000);
    EXPECT_NEAR(depth_at(2), 0, 1);
    long near = 1, far = 1;
    lgetdepth(&near, &far);
    EXPECT_EQ(near, 0);
    EXPECT_EQ(far, 0x7fffff);
    lshaderange(100, 300, 0, 0x7fffff);
    depthcue(TRUE);
    pnt(3, 2, -1);
    depthcue(FALSE);
    EXPECT_EQ(index_at(3, 2), 250);
    glcompat(GLC_ZRANGEMAP, 0);
}

TEST_F(IrisGlFragments, BlinkingColoursNeedAScreen) {
    cmode();
    mapcolor(20, 1, 2, 3);
    color(20);
    clear();
    blink(30, 20, 200, 100, 50);
    EXPECT_EQ(shown(4, 4), 0x030201u);
    blink(-1, 20, 0, 0, 0);
}

// A flat patch of the Bezier basis: its border is the square of its corners, inner curves cross it.
TEST_F(IrisGlFragments, AFlatPatchHasItsCurvesAtEqualSteps) {
    cmode();
    color(0);
    clear();
    color(5);
    const float bezier[4][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
    float x[4][4], y[4][4], z[4][4] = {};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            x[i][j] = float(4 * i);
            y[i][j] = float(4 * j);
        }
    defbasis(1, const_cast<float(*)[4]>(bezier));
    patchbasis(1, 1);
    patchcurves(4, 4);
    patchprecision(3, 3);
    patch(x, y, z);
    for (int j = 0; j <= 12; ++j)
        for (int i = 0; i <= 12; ++i)
            EXPECT_EQ(index_at(i, j), i % 4 == 0 || j % 4 == 0 ? 5 : 0) << i << ' ' << j;
    EXPECT_EQ(index_at(13, 4), 0);
}

}  // namespace gw::irisgl
