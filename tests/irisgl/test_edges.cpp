// Rules of the reference manual that programs rely on: which pixels polygons and lines own.
#include "tests/irisgl/manual.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gw::irisgl {

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

// The manual's example: the line from (0, 0) to (0, 2) has three pixels, with subpixel two.
TEST_F(IrisGlManual, LinesAreClosedUnlessSubpixelIsOn) {
    const auto pixels = [](Boolean on) {
        subpixel(on);
        color(0);
        clear();
        color(5);
        move2i(0, 0);
        draw2i(0, 2);
        return count_of(5);
    };
    EXPECT_EQ(pixels(FALSE), 3);
    EXPECT_EQ(pixels(TRUE), 2);
}

// Corners at 2.3 and 8.4: snapped to 2 and 8, columns 2 to 7; else 3 to 8.
TEST_F(IrisGlManual, VerticesAreInTheMiddlesOfPixelsUnlessSubpixelIsOn) {
    const auto draw = [](Boolean on) {
        subpixel(on);
        color(0);
        clear();
        color(5);
        bgnpolygon();
        for (const auto& [x, y] :
             {std::pair{2.3f, 2.3f}, {8.4f, 2.3f}, {8.4f, 8.4f}, {2.3f, 8.4f}}) {
            float v[2] = {x, y};
            v2f(v);
        }
        endpolygon();
        return count_of(5);
    };
    EXPECT_EQ(draw(FALSE), 36);
    EXPECT_EQ(index_at(2, 5), 5);
    EXPECT_EQ(index_at(8, 5), 0);
    EXPECT_EQ(draw(TRUE), 36);
    EXPECT_EQ(index_at(2, 5), 0);
    EXPECT_EQ(index_at(8, 5), 5);
}

// In perspective: x = 1.05 at z = -2 is 8 + 8 x 1.05 / 2 = 12.2 pixels, so column 12.
TEST_F(IrisGlManual, VerticesInPerspectiveAreInTheMiddlesOfPixelsToo) {
    color(0);
    clear();
    color(5);
    mmode(MVIEWING);
    perspective(900, 1, 1, 100);
    translate(0, 0, -2);
    bgnpolygon();
    for (const auto& [x, y] :
         {std::pair{-1.05f, -1.05f}, {1.05f, -1.05f}, {1.05f, 1.05f}, {-1.05f, 1.05f}}) {
        float v[2] = {x, y};
        v2f(v);
    }
    endpolygon();
    EXPECT_EQ(count_of(5), 81);  // from the middle of pixel 3 to that of pixel 12
    EXPECT_EQ(index_at(3, 8), 5);
    EXPECT_EQ(index_at(12, 8), 0);
}

TEST_F(IrisGlManual, AreasBetweenSidesOfPixelsKeepTheirPixels) {
    color(0);
    clear();
    color(5);
    ortho2(0, 16, 0, 16);
    bgnpolygon();
    for (const auto& [x, y] : {std::pair{0L, 0L}, {16L, 0L}, {16L, 16L}, {0L, 16L}}) {
        long v[2] = {x, y};
        v2i(v);
    }
    endpolygon();
    EXPECT_EQ(count_of(5), 256);
}

// A ring of 6 x 6 pixels: 36 - 16; with a triangle of 6 pixels a side all but those inside.
TEST_F(IrisGlManual, HollowPolygonsHaveTheEdgesOfFilledOnes) {
    const auto draw = [](long mode, const auto& shape) {
        color(0);
        clear();
        color(5);
        polymode(mode);
        shape();
        polymode(PYM_FILL);
        std::vector<int> pixels;
        for (int i = 0; i < 256; ++i) pixels.push_back(index_at(i % 16, i / 16));
        return pixels;
    };
    const auto square = [] {
        bgnpolygon();
        for (const auto& [x, y] : {std::pair{3L, 3L}, {9L, 3L}, {9L, 9L}, {3L, 9L}}) {
            long v[2] = {x, y};
            v2i(v);
        }
        endpolygon();
    };
    const auto triangles = [] {
        bgntmesh();
        for (const auto& [x, y] : {std::pair{1L, 1L}, {1L, 13L}, {12L, 1L}, {14L, 14L}}) {
            long v[2] = {x, y};
            v2i(v);
        }
        endtmesh();
    };
    const auto hollow = draw(PYM_HOLLOW, square);
    EXPECT_EQ(std::ranges::count(hollow, 5), 36 - 16);
    EXPECT_EQ(hollow[6 * 16 + 6], 0);
    EXPECT_EQ(hollow[6 * 16 + 3], 5);
    const auto filled = draw(PYM_FILL, triangles), edges = draw(PYM_HOLLOW, triangles);
    for (std::size_t i = 0; i < 256; ++i) EXPECT_TRUE(edges[i] == 0 || filled[i] == 5) << i;
    EXPECT_EQ(edges[4 * 16 + 4], 0) << "inside the first triangle";
    EXPECT_EQ(edges[10 * 16 + 10], 0) << "inside the second";
    EXPECT_EQ(edges[5 * 16 + 1], 5);
}

// 65 x 65 pixels in several squares of 32 x 32: the ring has 4 x 64.
TEST_F(IrisGlManual, LargeHollowPolygonsHaveOneRing) {
    prefsize(80, 80);
    const long large = winopen("large");
    color(0);
    clear();
    color(5);
    polymode(PYM_HOLLOW);
    bgnpolygon();
    for (const auto& [x, y] : {std::pair{5L, 5L}, {70L, 5L}, {70L, 70L}, {5L, 70L}}) {
        long v[2] = {x, y};
        v2i(v);
    }
    endpolygon();
    polymode(PYM_FILL);
    std::vector<short> pixels(6400);
    rectread(0, 0, 79, 79, pixels.data());
    EXPECT_EQ(std::ranges::count(pixels, short(5)), 256);
    winclose(large);
}

TEST_F(IrisGlManual, HollowPolygonsKeepTheColoursOfFilledOnes) {
    shademodel(GOURAUD);
    const auto draw = [](long mode) {
        color(0);
        clear();
        polymode(mode);
        bgnpolygon();
        for (const auto& [x, y] : {std::pair{1L, 1L}, {14L, 1L}, {14L, 14L}, {1L, 14L}}) {
            long v[2] = {x, y};
            color(Colorindex(1000 + 10 * x));
            v2i(v);
        }
        endpolygon();
        polymode(PYM_FILL);
        return std::pair{index_at(5, 14), index_at(5, 5)};
    };
    EXPECT_EQ(draw(PYM_FILL), (std::pair{1050, 1050}));
    EXPECT_EQ(draw(PYM_HOLLOW), (std::pair{1050, 0}));
}

TEST_F(IrisGlManual, AClearIsWholeWhateverPolygonsAre) {
    unsigned short half[16];
    std::ranges::fill(half, static_cast<unsigned short>(0xAAAA));
    defpattern(3, 16, half);
    const auto cleared = [](const auto& turn) {
        color(0);
        clear();
        turn(TRUE);
        setpattern(3);
        color(5);
        clear();
        setpattern(0);
        turn(FALSE);
        return count_of(5);
    };
    EXPECT_EQ(cleared([](Boolean on) { polymode(on ? PYM_LINE : PYM_FILL); }), 128);
    EXPECT_EQ(cleared([](Boolean on) { polymode(on ? PYM_HOLLOW : PYM_FILL); }), 128);
    EXPECT_EQ(cleared([](Boolean on) { frontface(on); }), 128);
}

// A matrix without an inverse: what is flat all the same has the same pixels.
TEST_F(IrisGlManual, WhatIsScaledFlatHasTheSamePixels) {
    const auto drawn = [](float z_scale) {
        color(0);
        clear();
        color(5);
        pushmatrix();
        scale(2, 2, z_scale);
        rectf(1.1f, 1.1f, 3.1f, 2.1f);
        float corners[3][2] = {{4.2f, 4.1f}, {6.9f, 4.3f}, {5, 6.8f}};
        bgnpolygon();
        for (auto& corner : corners) v2f(corner);
        endpolygon();
        circf(2, 6, 1);
        popmatrix();
        std::vector<int> pixels;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) pixels.push_back(index_at(x, y));
        return pixels;
    };
    EXPECT_EQ(drawn(0), drawn(1));
    EXPECT_EQ(drawn(1e-7f), drawn(1));
    EXPECT_GT(count_of(5), 20);
}

// A light at (8, 8, 8), a square of 2 x 2 at z = 4 around (8, 8): its shadow on z = 0 has 4 x 4,
// with the pixels of its left and upper sides.
TEST_F(IrisGlManual, AShadowOnAPlaneIsWhereTheLightThrowsIt) {
    ortho(-0.5f, 15.5f, -0.5f, 15.5f, -20, 20);
    for (const float almost : {0.0f, 1e-6f}) {
        Matrix onto_plane = {{8, 0, 0, 0}, {0, 8, 0, 0}, {0, 0, 8, -1}, {0, 0, 0, almost}};
        color(0);
        clear();
        pushmatrix();
        translate(8, 8, 8);
        multmatrix(onto_plane);
        color(5);
        float corners[4][3] = {{-1, -1, -4}, {1, -1, -4}, {1, 1, -4}, {-1, 1, -4}};
        bgnpolygon();
        for (auto& corner : corners) v3f(corner);
        endpolygon();
        popmatrix();
        EXPECT_EQ(count_of(5), 4 * 4) << almost;
        for (int y = 7; y <= 10; ++y)
            for (int x = 6; x < 10; ++x) EXPECT_EQ(index_at(x, y), 5) << x << " " << y;
    }
}

}  // namespace gw::irisgl
