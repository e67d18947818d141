// Evaluators against independent sums. [GL11] 5.1
#include "tests/gl/unit/support/picture.h"

#include <cmath>
#include <limits>

namespace gw::gl {
namespace {

double binomial(int n, int k) {
    double out = 1;
    for (int i = 1; i <= k; ++i) out = out * (n - k + i) / i;
    return out;
}
double bernstein(int n, int i, double u) {
    return binomial(n, i) * std::pow(u, i) * std::pow(1 - u, n - i);
}

/// The only vertex of a draw, by feedback in clip coordinates that are window coordinates.
template <class Draw>
std::array<GLfloat, 4> vertex(Draw draw) {
    std::array<GLfloat, 64> buffer{};
    glFeedbackBuffer(64, GL_3D_COLOR, buffer.data());
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_POINTS);
    draw();
    glEnd();
    EXPECT_EQ(glRenderMode(GL_RENDER), 8);
    return {buffer[1], buffer[2], buffer[3], buffer[4]};
}

constexpr std::array<float, 15> curve{2, 3, 0, 9, 30, 0.5f, 16, 1, -0.5f, 25, 25, 0, 30, 8, 0.25f};

}  // namespace

TEST(GlEvaluators, CurvesAreBernsteinSums) {
    const Window window;
    use_pixel_coordinates(window);
    glEnable(GL_MAP1_VERTEX_3);
    for (int order = 1; order <= 5; ++order) {
        glMap1f(GL_MAP1_VERTEX_3, 1, 3, 3, order, curve.data());
        for (const double u : {1.0, 1.25, 2.0, 2.9, 3.0}) {
            std::array<double, 3> sum{};
            for (int i = 0; i < order; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    sum[k] += bernstein(order - 1, i, (u - 1) / 2) *
                              double(curve[std::size_t(3 * i) + k]);
            const auto got = vertex([&] { glEvalCoord1d(u); });
            EXPECT_NEAR(double(got[0]), sum[0], 1e-5);
            EXPECT_NEAR(double(got[1]), sum[1], 1e-5);
            EXPECT_NEAR(double(got[2]), 0.5 - sum[2] / 2, 1e-6);
        }
    }
}

TEST(GlEvaluators, EvaluationLeavesTheCurrentValues) {
    const Window window;
    const std::array<float, 8> colors{1, 0, 0, 1, 0, 1, 0, 1};
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, colors.data());
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, curve.data());
    glEnable(GL_MAP1_COLOR_4);
    glEnable(GL_MAP1_VERTEX_3);
    glColor4f(0.5f, 0.25f, 1, 0.75f);
    glBegin(GL_POINTS);
    glEvalCoord1f(0.5f);
    glEnd();
    std::array<float, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    EXPECT_EQ(color, (std::array{0.5f, 0.25f, 1.0f, 0.75f}));
}

TEST(GlEvaluators, MeshesAreTheirVertices) {
    const auto set_up = [] {
        const float points[] = {2, 2, 0, 3, 29, 0, 28, 4, 0, 30, 30, 0};
        glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, points);
        glEnable(GL_MAP2_VERTEX_3);
        glMapGrid2f(4, 0, 1, 3, 0, 1);
    };
    expect_same_picture(
        [&] {
            set_up();
            glEvalMesh2(GL_FILL, 0, 4, 0, 3);
        },
        [&] {
            set_up();
            for (int j = 0; j < 3; ++j) {
                glBegin(GL_QUAD_STRIP);
                for (int i = 0; i <= 4; ++i) {
                    glEvalPoint2(i, j);
                    glEvalPoint2(i, j + 1);
                }
                glEnd();
            }
        });
    expect_same_picture(
        [&] {
            set_up();
            glEvalMesh2(GL_POINT, 1, 3, 0, 2);
        },
        [&] {
            set_up();
            glBegin(GL_POINTS);
            for (int j = 0; j <= 2; ++j)
                for (int i = 1; i <= 3; ++i) glEvalCoord2d(i * 0.25, j * (1.0 / 3));
            glEnd();
        });
}

TEST(GlEvaluators, WrongArgumentsAreErrors) {
    const Window window;
    const auto expect = [](GLenum error) { EXPECT_EQ(glGetError(), error); };
    glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, curve.data());
    expect(GL_INVALID_ENUM);
    glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, curve.data());
    expect(GL_INVALID_VALUE);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, curve.data());
    expect(GL_INVALID_VALUE);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, curve.data());
    expect(GL_INVALID_VALUE);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, curve.data());
    expect(GL_INVALID_VALUE);
    glMapGrid1f(0, 0, 1);
    expect(GL_INVALID_VALUE);
    glMapGrid2f(1, 0, 1, 0, 0, 1);
    expect(GL_INVALID_VALUE);
    glEvalMesh1(GL_FILL, 0, 1);
    expect(GL_INVALID_ENUM);
    glEvalMesh2(GL_RENDER, 0, 1, 0, 1);
    expect(GL_INVALID_ENUM);
}

TEST(GlEvaluators, AMapWithoutPointsStaysAsItWas) {
    const Window window;
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 5, nullptr);
    GLint order = 0;
    glGetMapiv(GL_MAP1_VERTEX_3, GL_ORDER, &order);
    EXPECT_EQ(order, 1);
}

TEST(GlEvaluators, MeshesOfTooManyPointsAreErrors) {
    const Window window;
    constexpr GLint low = std::numeric_limits<GLint>::min(),
                    high = std::numeric_limits<GLint>::max();
    glEvalMesh1(GL_LINE, low, high);
    EXPECT_EQ(glGetError(), GLenum(GL_OUT_OF_MEMORY));
    glEvalMesh2(GL_FILL, 0, 1 << 13, 0, 1 << 13);
    EXPECT_EQ(glGetError(), GLenum(GL_OUT_OF_MEMORY));
    // Ranges may end at the largest number.
    glEvalMesh1(GL_POINT, high - 1, high);
    glEvalMesh2(GL_LINE, high - 1, high, high - 1, high);
    glEvalMesh2(GL_FILL, high, low, high, low);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// [GL15] 5.1
TEST(GlEvaluators, MapsAreOfUnit0) {
    const Window window;
    glActiveTexture(GL_TEXTURE1);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 5, curve.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 5, curve.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glActiveTexture(GL_TEXTURE0);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 5, curve.data());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace gw::gl
