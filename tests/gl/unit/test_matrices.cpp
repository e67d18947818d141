// Matrices against independent arithmetic. [GL11] 2.10, 2.11
#include "tests/gl/unit/support/window.h"

#include <algorithm>
#include <cmath>

namespace gw::gl {
namespace {

using Matrix = std::array<double, 16>;
constexpr Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// [GL11] 2.10.2: columns follow each other in memory.
Matrix times(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k)
                out[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return out;
}
Matrix get(GLenum name) {
    Matrix out{};
    glGetDoublev(name, out.data());
    return out;
}

/// Integers: products and sums are exact.
constexpr Matrix counting{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
constexpr Matrix mixed{2, -1, 0, 3, 1, 4, -2, 0, 0, 5, 1, -3, 7, 0, 2, 1};

/// Matrices hold floats.
void expect_floats_of(const Matrix& a, const Matrix& b) {
    for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(a[i], double(float(b[i]))) << i;
}

struct Stack {
    GLenum mode, matrix, depth;
    int largest;
};
constexpr Stack stacks[] = {{GL_MODELVIEW, GL_MODELVIEW_MATRIX, GL_MODELVIEW_STACK_DEPTH, 32},
                            {GL_PROJECTION, GL_PROJECTION_MATRIX, GL_PROJECTION_STACK_DEPTH, 10},
                            {GL_TEXTURE, GL_TEXTURE_MATRIX, GL_TEXTURE_STACK_DEPTH, 10}};

}  // namespace

TEST(GlMatrices, LoadAndMultiplyFromTheRight) {
    const Window window;
    for (const Stack& stack : stacks) {
        glMatrixMode(stack.mode);
        EXPECT_EQ(get(stack.matrix), identity);
        glLoadMatrixd(counting.data());
        EXPECT_EQ(get(stack.matrix), counting);
        glMultMatrixd(mixed.data());
        EXPECT_EQ(get(stack.matrix), times(counting, mixed));
        std::array<float, 16> single{};
        std::copy(mixed.begin(), mixed.end(), single.begin());
        glMultMatrixf(single.data());
        EXPECT_EQ(get(stack.matrix), times(times(counting, mixed), mixed));
        glLoadMatrixf(single.data());
        EXPECT_EQ(get(stack.matrix), mixed);
        glLoadIdentity();
        EXPECT_EQ(get(stack.matrix), identity);
    }
}

TEST(GlMatrices, TranslateAndScale) {
    const Window window;
    glLoadMatrixd(mixed.data());
    glTranslated(3, -5, 7);
    EXPECT_EQ(get(GL_MODELVIEW_MATRIX),
              times(mixed, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, -5, 7, 1}));
    glLoadMatrixd(mixed.data());
    glScalef(2, -3, 0.5f);
    EXPECT_EQ(get(GL_MODELVIEW_MATRIX),
              times(mixed, {2, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1}));
}

TEST(GlMatrices, RotateByRightAnglesIsExact) {
    const Window window;
    const Matrix about_z{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const Matrix about_x{1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
    const Matrix about_y{0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1};
    const auto rotated = [](double angle, double x, double y, double z) {
        glLoadIdentity();
        glRotated(angle, x, y, z);
        return get(GL_MODELVIEW_MATRIX);
    };
    EXPECT_EQ(rotated(90, 0, 0, 5), about_z);
    EXPECT_EQ(rotated(90, 2, 0, 0), about_x);
    EXPECT_EQ(rotated(90, 0, 1, 0), about_y);
    EXPECT_EQ(rotated(-270, 0, 0, 1), about_z);
    EXPECT_EQ(rotated(3690, 0, 0, 1), about_z);
    EXPECT_EQ(rotated(0, 1, 2, 3), identity);
}

TEST(GlMatrices, RotateAboutAnyAxis) {
    const Window window;
    const double pi = std::acos(-1.0), angle = 37;
    const double s = std::sin(angle * pi / 180), c = std::cos(angle * pi / 180);
    const double size = std::sqrt(14.0), x = 1 / size, y = 2 / size, z = 3 / size;
    glRotated(angle, 1, 2, 3);
    expect_floats_of(
        get(GL_MODELVIEW_MATRIX),
        {x * x * (1 - c) + c, y * x * (1 - c) + z * s, x * z * (1 - c) - y * s, 0,
         x * y * (1 - c) - z * s, y * y * (1 - c) + c, y * z * (1 - c) + x * s, 0,
         x * z * (1 - c) + y * s, y * z * (1 - c) - x * s, z * z * (1 - c) + c, 0, 0, 0, 0, 1});
}

TEST(GlMatrices, OrthoAndFrustum) {
    const Window window;
    glLoadMatrixd(counting.data());
    glOrtho(-2, 6, 1, 5, -3, 1);
    EXPECT_EQ(get(GL_MODELVIEW_MATRIX),
              times(counting, {0.25, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -0.5, 0, -0.5, -1.5, 0.5, 1}));
    glLoadMatrixd(counting.data());
    glFrustum(-2, 6, 1, 5, 2, 6);
    EXPECT_EQ(get(GL_MODELVIEW_MATRIX),
              times(counting, {0.5, 0, 0, 0, 0, 1, 0, 0, 0.5, 1.5, -2, -1, 0, 0, -6, 0}));
    for (const auto& v : {std::array<double, 6>{1, 1, 0, 1, 1, 2},
                          {0, 1, 2, 2, 1, 2},
                          {0, 1, 0, 1, 3, 3},
                          {0, 1, 0, 1, -1, 2},
                          {0, 1, 0, 1, 1, 0}}) {
        glFrustum(v[0], v[1], v[2], v[3], v[4], v[5]);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    }
    glOrtho(0, 1, 0, 1, 2, 2);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

TEST(GlMatrices, WhatLiesOnTheNearOrFarPlaneIsInside) {
    Window window;
    const auto is_drawn = [&](double depth, double eye_z) {
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glTranslated(0, 0, eye_z);
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            glVertex3d(x * depth, y * depth, -depth - eye_z);
        glEnd();
        glRasterPos3d(0, 0, -depth - eye_z);
        GLboolean valid = GL_FALSE;
        glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
        return valid && window.pixel(16, 16)[0] == 255;
    };
    for (const double near : {0.015625, 0.25, 1.0, 1.5, 3.0, 10.0})
        for (const double far : {20.0, 50.0, 100.0, 256.0, 1000.0, 100000.0})
            for (const auto& set : {glFrustum, glOrtho})
                for (const double eye_z : {0.0, -0.25, -8.0}) {
                    SCOPED_TRACE(testing::Message() << near << " to " << far << ", " << eye_z);
                    glMatrixMode(GL_PROJECTION);
                    glLoadIdentity();
                    set(-near, near, -near, near, near, far);
                    EXPECT_TRUE(is_drawn(near, eye_z));
                    EXPECT_TRUE(is_drawn(far, eye_z));
                    // What a matrix of floats tells apart.
                    const double beyond = std::max(1e-3, 0x1p-20 * far / near);
                    EXPECT_FALSE(is_drawn(near * (1 - beyond), eye_z));
                    EXPECT_FALSE(is_drawn(far * (1 + beyond), eye_z));
                }
}

/// Each call that changes a matrix, with numbers that no float has.
void change_matrix(int call, double k) {
    const std::array<double, 16> m{1.1,   0.2, k,   0.1, 0.3, 0.9, 0.7, 0,
                                   1 / k, 0.1, 1.3, 0.6, 0.4, 0.8, k,   1};
    switch (call) {
        case 0: return glLoadMatrixd(m.data());
        case 1: return glMultMatrixd(m.data());
        case 2: return glRotated(37 * k, 1, 2, 3);
        case 3: return glTranslated(k, 0.1, 1 / k);
        case 4: return glScaled(k, 1 / k, 1.1);
        case 5: return glFrustum(-0.1 * k, 0.3, -0.2, 0.1, 0.1, 100 * k);
        case 6: return glOrtho(-0.1 * k, 0.3, -0.2, 0.1, 0.1, 100 * k);
        case 7: return glLoadTransposeMatrixd(m.data());
        case 8: return glMultTransposeMatrixd(m.data());
    }
}

TEST(GlMatrices, SurviveGetFloatvAndLoadMatrixfToTheBit) {
    const Window window;
    for (const Stack& stack : stacks) {
        glMatrixMode(stack.mode);
        for (int step = 0; step < 90; ++step) {
            if (step % 9 == 5) glLoadIdentity();
            change_matrix(step % 9, 1 + 0.37 * step);
            std::array<float, 16> floats{};
            const Matrix before = get(stack.matrix);
            glGetFloatv(stack.matrix, floats.data());
            glLoadMatrixf(floats.data());
            EXPECT_EQ(get(stack.matrix), before) << "step " << step;
        }
    }
}

void draw_floor() {
    constexpr int quads = 80;
    constexpr float size = 10;
    glBegin(GL_QUADS);
    for (int y = 0; y < quads; ++y)
        for (int x = 0; x < quads; ++x)
            for (const auto& [i, k] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                glVertex3f(2 * size * float(x + i) / quads - size,
                           2 * size * float(y + k) / quads - size, 0);
    glEnd();
}

/// A light's pass, as renderers add one to the other: the matrices are read, others are loaded, and
/// the first are loaded again. The same floor passes the depth test in every pixel.
TEST(GlMatrices, AFloorThatIsDrawnAgainWithReloadedMatricesHitsEveryPixel) {
    Window window(128, 128);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int picture = 0; picture < 20; ++picture) {
        glDisable(GL_BLEND);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.0138, 0.0138, -0.0104, 0.0104, 0.025, 50 + 0.7 * picture);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glRotated(-60 - picture, 1, 0, 0);
        glRotated(17.3 * picture, 0, 0, 1);
        glTranslated(0.1 * picture, -0.3, -1.7);
        std::array<float, 16> projection{}, modelview{};
        glGetFloatv(GL_PROJECTION_MATRIX, projection.data());
        glGetFloatv(GL_MODELVIEW_MATRIX, modelview.data());
        glColor3f(1, 0, 0);
        draw_floor();
        glLoadIdentity();
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glLoadMatrixf(projection.data());
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(modelview.data());
        glEnable(GL_BLEND);
        glColor3f(0, 1, 0);
        draw_floor();
        int first = 0, missed = 0;
        for (const auto& pixel : window.pixels()) {
            first += pixel[0] != 0;
            missed += pixel[0] != 0 && pixel[1] == 0;
        }
        EXPECT_GT(first, 4000) << picture;
        EXPECT_EQ(missed, 0) << picture;
    }
}

TEST(GlMatrices, TransposedMatricesHaveRowsThatFollowEachOther) {
    const Window window;
    Matrix transposed{};
    for (std::size_t i = 0; i < 16; ++i) transposed[i] = mixed[4 * (i % 4) + i / 4];
    std::array<float, 16> single{};
    std::copy(transposed.begin(), transposed.end(), single.begin());
    for (const auto& [stack, query] : {std::pair(stacks[0], GLenum(GL_TRANSPOSE_MODELVIEW_MATRIX)),
                                       {stacks[1], GL_TRANSPOSE_PROJECTION_MATRIX},
                                       {stacks[2], GL_TRANSPOSE_TEXTURE_MATRIX}}) {
        glMatrixMode(stack.mode);
        glLoadTransposeMatrixd(transposed.data());
        EXPECT_EQ(get(stack.matrix), mixed);
        EXPECT_EQ(get(query), transposed);
        glMultTransposeMatrixf(single.data());
        EXPECT_EQ(get(stack.matrix), times(mixed, mixed));
        glLoadTransposeMatrixf(single.data());
        EXPECT_EQ(get(stack.matrix), mixed);
        glMultTransposeMatrixd(transposed.data());
        EXPECT_EQ(get(stack.matrix), times(mixed, mixed));
    }
}

TEST(GlMatrices, StacksHaveTheirDepths) {
    const Window window;
    for (const Stack& stack : stacks) {
        glMatrixMode(stack.mode);
        glPopMatrix();
        EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
        GLint depth = 0;
        for (int i = 1; i < stack.largest; ++i) {
            glGetIntegerv(stack.depth, &depth);
            EXPECT_EQ(depth, i);
            glPushMatrix();
            glTranslatef(1, 0, 0);
        }
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        glPushMatrix();
        EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
        EXPECT_EQ(get(stack.matrix)[12], stack.largest - 1);
        for (int i = 1; i < stack.largest; ++i) glPopMatrix();
        EXPECT_EQ(get(stack.matrix), identity);
        glPopMatrix();
        EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
    }
}

TEST(GlMatrices, PlanesGoThroughTheInverseModelview) {
    const Window window;
    // The inverse has powers of two only: its products are exact.
    const Matrix model{2, 0, 0, 0, 0, 0, 4, 0, 0, -0.5, 0, 0, 3, -1, 8, 1};
    const Matrix inverse{0.5, 0, 0, 0, 0, 0, -2, 0, 0, 0.25, 0, 0, -1.5, -2, -2, 1};
    ASSERT_EQ(times(model, inverse), identity);
    glLoadMatrixd(model.data());
    const std::array<double, 4> plane{1, -2, 3, 4};
    std::array<double, 4> expected{}, got{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t k = 0; k < 4; ++k) expected[column] += plane[k] * inverse[4 * column + k];
    for (GLenum i = GL_CLIP_PLANE0; i <= GL_CLIP_PLANE5; ++i) {
        glClipPlane(i, plane.data());
        glGetClipPlane(i, got.data());
        EXPECT_EQ(got, expected);
    }
    for (const GLenum coord : {GL_S, GL_T, GL_R, GL_Q}) {
        glTexGendv(coord, GL_EYE_PLANE, plane.data());
        glGetTexGendv(coord, GL_EYE_PLANE, got.data());
        EXPECT_EQ(got, expected);
        glTexGendv(coord, GL_OBJECT_PLANE, plane.data());
        glGetTexGendv(coord, GL_OBJECT_PLANE, got.data());
        EXPECT_EQ(got, plane);
    }
}

TEST(GlMatrices, ModesAreThree) {
    const Window window;
    glMatrixMode(GL_COLOR);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    GLint mode = 0;
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    EXPECT_EQ(mode, GL_MODELVIEW);
}

}  // namespace gw::gl
