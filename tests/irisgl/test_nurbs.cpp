// NURBS: surfaces and curves whose pixels are known, trimming loops.
#include "tests/irisgl/support.h"

#include <cmath>
#include <vector>

namespace gw::irisgl {

class IrisGlNurbs : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        setnurbsproperty(N_DISPLAY, float(N_FILL));
        setnurbsproperty(N_PIXEL_TOLERANCE, 50);
        color(0);
        clear();
        color(5);
    }
    /// Bilinear: s and t of 0 .. 1 are the pixels 0 to 11.
    static void square() {
        double knots[] = {0, 0, 1, 1};
        double control[2][2][3] = {{{-0.5, -0.5, 0}, {-0.5, 11.5, 0}},
                                   {{11.5, -0.5, 0}, {11.5, 11.5, 0}}};
        nurbssurface(4, knots, 4, knots, 48, 24, &control[0][0][0], 2, 2, N_XYZ);
    }
    static void loop(std::vector<double> st) {
        bgntrim();
        pwlcurve(long(st.size() / 2), st.data(), 16, N_ST);
        endtrim();
    }
};

TEST_F(IrisGlNurbs, ASurfaceWithoutLoopsIsWhole) {
    bgnsurface();
    square();
    endsurface();
    EXPECT_EQ(count_of(5), 144);
}

TEST_F(IrisGlNurbs, ALoopThatRunsToTheLeftKeepsItsInside) {
    bgnsurface();
    square();
    loop({0.25, 0.25, 0.75, 0.25, 0.75, 0.75, 0.25, 0.75, 0.25, 0.25});
    endsurface();
    EXPECT_EQ(count_of(5), 36);
    EXPECT_EQ(index_at(3, 3), 5);
    EXPECT_EQ(index_at(8, 8), 5);
    EXPECT_EQ(index_at(9, 5), 0);
}

TEST_F(IrisGlNurbs, ALoopThatRunsToTheRightIsAHole) {
    bgnsurface();
    square();
    loop({0.25, 0.25, 0.25, 0.75, 0.75, 0.75, 0.75, 0.25});
    endsurface();
    EXPECT_EQ(count_of(5), 144 - 36);
    EXPECT_EQ(index_at(5, 5), 0);
    EXPECT_EQ(index_at(2, 5), 5);
    EXPECT_EQ(index_at(5, 1), 5);
}

TEST_F(IrisGlNurbs, NestedLoopsAlternate) {
    bgnsurface();
    square();
    loop({0, 0, 1, 0, 1, 1, 0, 1});
    loop({0.25, 0.25, 0.25, 0.75, 0.75, 0.75, 0.75, 0.25});
    endsurface();
    EXPECT_EQ(count_of(5), 144 - 36);
}

TEST_F(IrisGlNurbs, ALoopMayBeSeveralCurves) {
    double knots[] = {0, 0, 1, 2, 3, 3};
    double three[][2] = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
    double last[] = {0.25, 0.75, 0.25, 0.25};
    bgnsurface();
    square();
    bgntrim();
    nurbscurve(6, knots, 16, &three[0][0], 2, N_ST);
    pwlcurve(2, last, 16, N_ST);
    endtrim();
    endsurface();
    EXPECT_EQ(count_of(5), 36);
}

// Cubic Bezier rows of equal steps are the same plane as the bilinear surface.
TEST_F(IrisGlNurbs, ASurfaceOfHigherOrderInItsPlaneIsThatPlane) {
    double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    double control[4][4][3];
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) {
            control[i][k][0] = -0.5 + 4 * i;
            control[i][k][1] = -0.5 + 4 * k;
            control[i][k][2] = 0;
        }
    bgnsurface();
    nurbssurface(8, knots, 8, knots, 96, 24, &control[0][0][0], 4, 4, N_XYZ);
    endsurface();
    EXPECT_EQ(count_of(5), 144);
}

// A quarter of a circle as a rational curve of order 3: (r, 0), (r, r) with 1 / sqrt 2, (0, r).
TEST_F(IrisGlNurbs, ARationalCurveIsACircle) {
    const double r = 12, w = std::sqrt(0.5);
    double knots[] = {0, 0, 0, 1, 1, 1};
    double control[] = {r, 0, 0, 1, r * w, r * w, 0, w, 0, r, 0, 1};
    std::vector<float> buffer(2000);
    feedback(buffer.data(), 2000);
    bgncurve();
    nurbscurve(6, knots, 32, control, 3, N_XYZW);
    endcurve();
    const long count = endfeedback(buffer.data());
    ASSERT_GT(count, 20);
    for (long i = 0; i < count; i += 20)
        for (long end = i + 2; end < i + 20; end += 9) {
            const double x = double(buffer[std::size_t(end)]),
                         y = double(buffer[std::size_t(end + 1)]);
            EXPECT_NEAR(std::hypot(x, y), r, 1e-4);
        }
}

TEST_F(IrisGlNurbs, ThePatchsOutlineIsItsBorder) {
    setnurbsproperty(N_DISPLAY, float(N_OUTLINE_PATCH));
    double knots[] = {0, 0, 1, 1};
    double control[2][2][3] = {{{1, 1, 0}, {1, 10, 0}}, {{10, 1, 0}, {10, 10, 0}}};
    bgnsurface();
    nurbssurface(4, knots, 4, knots, 48, 24, &control[0][0][0], 2, 2, N_XYZ);
    endsurface();
    EXPECT_EQ(count_of(5), 36);
    EXPECT_EQ(index_at(5, 5), 0);
}

TEST_F(IrisGlNurbs, ALitSurfaceHasTheNormalOfItsPlane) {
    RGBmode();
    cpack(0xFF000000);
    clear();
    mmode(MVIEWING);
    ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    float material[] = {AMBIENT, 0, 0, 0, DIFFUSE, 1, 1, 1, LMNULL};
    float model[] = {AMBIENT, 0, 0, 0, LMNULL};
    float light[] = {LCOLOR, 0, 1, 0, POSITION, 0, 0, 1, 0, LMNULL};
    lmdef(DEFMATERIAL, 41, 9, material);
    lmdef(DEFLMODEL, 41, 5, model);
    lmdef(DEFLIGHT, 41, 10, light);
    lmbind(MATERIAL, 41);
    lmbind(LMODEL, 41);
    lmbind(LIGHT0, 41);
    bgnsurface();
    square();
    endsurface();
    EXPECT_EQ(shown(5, 5), 0x00FF00u);
    lmbind(MATERIAL, 0);
}

TEST_F(IrisGlNurbs, PropertiesAreKeptAndWrongDefinitionsIgnored) {
    float value = 0;
    getnurbsproperty(N_PIXEL_TOLERANCE, &value);
    EXPECT_EQ(value, 50);
    setnurbsproperty(77, 3);
    double falling[] = {1, 1, 0, 0}, control[12] = {};
    square();  // outside bgnsurface
    bgnsurface();
    nurbssurface(4, falling, 4, falling, 48, 24, control, 2, 2, N_XYZ);
    endsurface();
    endtrim();
    endcurve();
    EXPECT_EQ(count_of(5), 0);
}

}  // namespace gw::irisgl
