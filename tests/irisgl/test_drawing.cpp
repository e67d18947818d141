#include "tests/irisgl/support.h"

#include <vector>

namespace gw::irisgl {

class IrisGlDrawing : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        color(0);
        clear();
        color(5);
    }
};

TEST_F(IrisGlDrawing, FilledRectanglesOwnThePixelsOfAllTheirEdges) {
    rectfi(3, 4, 7, 9);
    EXPECT_EQ(count_of(5), 5 * 6);
    EXPECT_EQ(index_at(3, 4), 5);
    EXPECT_EQ(index_at(7, 9), 5);
    EXPECT_EQ(index_at(8, 9), 0);
}

TEST_F(IrisGlDrawing, ARectangleOfNoWidthIsAColumnOfPixels) {
    rectfi(6, 2, 6, 5);
    EXPECT_EQ(count_of(5), 4);
}

TEST_F(IrisGlDrawing, ALineOwnsBothItsEnds) {
    move2i(2, 3);
    draw2i(9, 3);
    EXPECT_EQ(count_of(5), 8);
    EXPECT_EQ(index_at(2, 3), 5);
    EXPECT_EQ(index_at(9, 3), 5);
}

TEST_F(IrisGlDrawing, ConcavePolygonsLeaveTheirNotchEmpty) {
    concave(TRUE);
    subpixel(TRUE);
    const float p[6][2] = {{0.5f, 0.5f}, {12.5f, 0.5f}, {12.5f, 4.5f},
                           {4.5f, 4.5f}, {4.5f, 12.5f}, {0.5f, 12.5f}};
    polf2(6, const_cast<float(*)[2]>(p));
    EXPECT_EQ(count_of(5), 12 * 4 + 4 * 8);
    EXPECT_EQ(index_at(8, 8), 0);
}

// Without swaps a mesh of 0, 1, 2, 3 has the triangles 012 and 123. A swap before 2 keeps 0 for 3: 023.
TEST_F(IrisGlDrawing, SwaptmeshTurnsTheFanOfAMesh) {
    const float v[4][2] = {{-0.5f, -0.5f}, {7.5f, -0.5f}, {7.5f, 7.5f}, {-0.5f, 7.5f}};
    for (const bool swaps : {false, true}) {
        color(0);
        clear();
        color(5);
        bgntmesh();
        for (int i = 0; i < 4; ++i) {
            if (i == 2 && swaps) swaptmesh();
            v2f(const_cast<float*>(v[i]));
        }
        endtmesh();
        EXPECT_EQ(index_at(6, 3), 5);
        EXPECT_EQ(index_at(1, 5), swaps ? 5 : 0);  // 023 has it, 123 has not
        EXPECT_EQ(index_at(6, 5), 5);
        EXPECT_EQ(index_at(9, 3), 0);
        if (swaps) {
            EXPECT_EQ(count_of(5), 64);
        }
    }
}

TEST_F(IrisGlDrawing, APatternOfSixteenBitsRepeats) {
    unsigned short rows[16];
    for (auto& row : rows) row = 0x8000;
    defpattern(1, 16, rows);
    setpattern(1);
    clear();
    EXPECT_EQ(count_of(5), 16);
    EXPECT_EQ(index_at(0, 9), 5);
}

TEST_F(IrisGlDrawing, PopmatrixUnderAnEmptyStackIsIgnored) {
    float before[4][4], after[4][4];
    getmatrix(before);
    popmatrix();
    popviewport();
    getmatrix(after);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(before[i / 4][i % 4], after[i / 4][i % 4]);
    for (int i = 0; i < 100; ++i) pushmatrix();
}

TEST_F(IrisGlDrawing, MatricesAreRowsThatMultiplyFromTheLeft) {
    float m[4][4];
    const float one[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    loadmatrix(const_cast<float(*)[4]>(one));
    translate(3, 4, 5);
    rotate(900, 'z');
    scale(2, 1, 1);
    getmatrix(m);
    EXPECT_EQ(m[0][1], 2);  // x goes to y, twice as long
    EXPECT_EQ(m[1][0], -1);
    EXPECT_EQ(m[3][0], 3);
    EXPECT_EQ(m[3][1], 4);
}

TEST_F(IrisGlDrawing, LookatPutsThePointOnTheAxisInFrontOfTheEye) {
    mmode(MVIEWING);
    lookat(1, 2, 3, 4, 6, 15, 0);
    float m[4][4];
    getmatrix(m);
    float eye[3];
    for (int i = 0; i < 3; ++i) eye[i] = 4 * m[0][i] + 6 * m[1][i] + 15 * m[2][i] + m[3][i];
    EXPECT_NEAR(eye[0], 0, 1e-5);
    EXPECT_NEAR(eye[1], 0, 1e-5);
    EXPECT_NEAR(eye[2], -13, 1e-5);
}

TEST_F(IrisGlDrawing, DepthsAreSignedAndTheNearerWins) {
    zbuffer(TRUE);
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -10, 10);
    zclear();
    const float near_ones[4][3] = {{0, 0, 1}, {12, 0, 1}, {12, 12, 1}, {0, 12, 1}};
    const float far_ones[4][3] = {{0, 0, -1}, {12, 0, -1}, {12, 12, -1}, {0, 12, -1}};
    polf(4, const_cast<float(*)[3]>(near_ones));
    color(6);
    polf(4, const_cast<float(*)[3]>(far_ones));
    EXPECT_EQ(index_at(5, 5), 5);
    czclear(0, -0x800000);
    polf(4, const_cast<float(*)[3]>(near_ones));
    EXPECT_EQ(index_at(5, 5), 0);
}

TEST_F(IrisGlDrawing, AllBitsSetClearTheDepthsToTheFarthest) {
    const float far_one[4][3] = {{0, 0, -1}, {12, 0, -1}, {12, 12, -1}, {0, 12, -1}};
    zbuffer(TRUE);
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -10, 10);
    for (const long depth : {0x7fffffL, 0xffffffffL}) {
        czclear(0, depth);
        polf(4, const_cast<float(*)[3]>(far_one));
        EXPECT_EQ(index_at(5, 5), 5) << depth;
    }
    for (const long depth : {-1L, 0xff800000L}) {  // -1 is nearer than the polygon
        czclear(0, depth);
        polf(4, const_cast<float(*)[3]>(far_one));
        EXPECT_EQ(index_at(5, 5), 0) << depth;
    }
}

TEST_F(IrisGlDrawing, CharactersMoveTheCharacterPosition) {
    short x = 0, y = 0;
    cmov2i(1, 2);
    charstr(const_cast<char*>("I"));
    getcpos(&x, &y);
    EXPECT_EQ(x, 1 + strwidth(const_cast<char*>("I")));
    EXPECT_EQ(y, 2);
    EXPECT_GT(count_of(5), 10);
}

// A font as high as font 0 draws its pixels; larger ones draw more.
TEST_F(IrisGlDrawing, TheFontManagerScalesTheScreensFont) {
    char text[] = "I";
    const fmfonthandle same = fmscalefont(fmfindfont(const_cast<char*>("Screen")), 15),
                       small = fmscalefont(same, 1.0 / 3), large = fmscalefont(small, 3);
    fmfontinfo info{};
    EXPECT_EQ(fmgetfontinfo(same, &info), 0);
    EXPECT_EQ(info.height, getheight());
    EXPECT_EQ(fmgetstrwidth(same, text), strwidth(text));
    EXPECT_EQ(fmgetstrwidth(small, text), strwidth(text) / 3);
    cmov2i(1, 2);
    charstr(text);
    std::vector<int> expected;
    for (int i = 0; i < 256; ++i) expected.push_back(index_at(i % 16, i / 16));
    for (const fmfonthandle font : {same, large}) {
        color(0);
        clear();
        color(5);
        fmsetfont(font);
        cmov2i(1, 2);
        EXPECT_EQ(fmprstr(text), strwidth(text));
        for (int i = 0; i < 256; ++i) EXPECT_EQ(index_at(i % 16, i / 16), expected[std::size_t(i)]);
    }
    const int drawn = count_of(5);
    fmsetfont(fmscalefont(same, 2));
    color(0);
    clear();
    color(5);
    cmov2i(0, 0);
    fmprstr(text);
    EXPECT_GT(count_of(5), drawn);
    fmfreefont(same);
    EXPECT_EQ(fmgetstrwidth(same, text), -1);
    EXPECT_EQ(fmscalefont(same, 2), 0);
}

TEST_F(IrisGlDrawing, ACubicCurveOfTheBezierBasisMeetsItsEnds) {
    const float bezier[4][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
    const float p[4][3] = {{1, 1, 0}, {1, 13, 0}, {13, 13, 0}, {13, 1, 0}};
    defbasis(1, const_cast<float(*)[4]>(bezier));
    curvebasis(1);
    crv(const_cast<float(*)[3]>(p));
    EXPECT_EQ(index_at(1, 1), 5);
    EXPECT_EQ(index_at(13, 1), 5);
    EXPECT_EQ(index_at(7, 10), 5);  // t = 1/2: (7, 10)
}

}  // namespace gw::irisgl
