// Begin and End: the modes, and how runs become primitives. [GL11] 2.6
#include "tests/gl/unit/support/window.h"

#include <cmath>

namespace gw::gl {
namespace {

struct Point {
    float x, y;
};
const std::vector<Point> corners{{2, 2}, {4, 28}, {14, 3}, {16, 29}, {24, 2}, {28, 27}, {30, 4}};

void color_of(std::size_t i) {
    const auto bits = static_cast<unsigned>(i + 1);
    glColor3ub(GLubyte(40 * (bits & 7)), GLubyte(255 - 30 * bits), GLubyte(bits % 2 ? 255 : 0));
}

void send(const std::vector<std::size_t>& order) {
    for (const std::size_t i : order) {
        color_of(i);
        glVertex2f(corners[i].x, corners[i].y);
    }
}

/// The picture of runs: each a mode and the corners in their order.
struct VertexRun {
    GLenum mode;
    std::vector<std::size_t> order;
};
std::vector<std::array<GLubyte, 4>> picture(const std::vector<VertexRun>& runs,
                                            GLenum shade_model) {
    Window window;
    use_pixel_coordinates(window);
    glShadeModel(shade_model);
    glEnable(GL_BLEND);  // shows what is drawn twice
    glBlendFunc(GL_ONE, GL_ONE);
    for (const VertexRun& run : runs) {
        glBegin(run.mode);
        send(run.order);
        glEnd();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    return window.pixels();
}

struct Equivalence {
    const char* name;
    std::vector<VertexRun> runs, same;
};
const std::vector<Equivalence> equivalences{
    {"TRIANGLE_STRIP",
     {{GL_TRIANGLE_STRIP, {0, 1, 2, 3, 4}}},
     {{GL_TRIANGLES, {0, 1, 2, 2, 1, 3, 2, 3, 4}}}},
    {"TRIANGLE_FAN",
     {{GL_TRIANGLE_FAN, {0, 2, 4, 5, 3}}},
     {{GL_TRIANGLES, {0, 2, 4, 0, 4, 5, 0, 5, 3}}}},
    {"QUAD_STRIP",
     {{GL_QUAD_STRIP, {0, 1, 2, 3, 4, 5}}},
     {{GL_QUADS, {2, 0, 1, 3}}, {GL_QUADS, {4, 2, 3, 5}}}},
    {"LINE_LOOP", {{GL_LINE_LOOP, {0, 2, 5, 1}}}, {{GL_LINE_STRIP, {0, 2, 5, 1, 0}}}},
    {"LINE_STRIP", {{GL_LINE_STRIP, {0, 2, 5}}}, {{GL_LINES, {0, 2}}, {GL_LINES, {2, 5}}}},
    {"two strips as one mesh",
     {{GL_TRIANGLE_STRIP, {0, 1, 2}}, {GL_TRIANGLES, {2, 3, 4}}, {GL_TRIANGLE_FAN, {4, 5, 6}}},
     {{GL_TRIANGLES, {0, 1, 2, 2, 3, 4, 4, 5, 6}}}},
    {"TRIANGLES with 5 vertices", {{GL_TRIANGLES, {0, 1, 2, 3, 4}}}, {{GL_TRIANGLES, {0, 1, 2}}}},
    {"QUADS with 7 vertices", {{GL_QUADS, {0, 1, 3, 2, 4, 5, 6}}}, {{GL_QUADS, {0, 1, 3, 2}}}},
    {"QUAD_STRIP with 5 vertices",
     {{GL_QUAD_STRIP, {0, 1, 2, 3, 4}}},
     {{GL_QUAD_STRIP, {0, 1, 2, 3}}}},
    {"LINES with 3 vertices", {{GL_LINES, {0, 5, 3}}}, {{GL_LINES, {0, 5}}}},
    {"runs too short",
     {{GL_TRIANGLE_STRIP, {0, 1}},
      {GL_TRIANGLE_FAN, {0, 1}},
      {GL_POLYGON, {0, 1}},
      {GL_QUAD_STRIP, {0, 1, 2}},
      {GL_LINE_STRIP, {0}},
      {GL_TRIANGLES, {0, 1, 2}}},
     {{GL_TRIANGLES, {0, 1, 2}}}},
};

TEST(BeginEnd, ModesAreThePrimitivesThatTheyStandFor) {
    for (const GLenum shade_model : {GL_FLAT, GL_SMOOTH})
        for (const Equivalence& e : equivalences)
            EXPECT_EQ(picture(e.runs, shade_model), picture(e.same, shade_model))
                << e.name << (shade_model == GL_FLAT ? " flat" : " smooth");
}

/// [GL11] table 2.12: the vertex of each primitive that gives a flat colour.
TEST(BeginEnd, FlatColoursComeFromTheProvokingVertex) {
    const std::vector<std::pair<VertexRun, std::size_t>> cases{
        {{GL_POLYGON, {0, 4, 5, 1}}, 0},
        {{GL_TRIANGLES, {0, 4, 5}}, 5},
        {{GL_TRIANGLE_STRIP, {0, 4, 5}}, 5},
        {{GL_TRIANGLE_FAN, {0, 4, 5}}, 5},
        {{GL_QUADS, {0, 4, 5, 1}}, 1},
        {{GL_QUAD_STRIP, {0, 1, 4, 5}}, 5},
        {{GL_LINES, {0, 5}}, 5},
        {{GL_LINE_STRIP, {0, 5}}, 5},
    };
    for (const auto& [run, provoking] : cases) {
        Window window;
        use_pixel_coordinates(window);
        glShadeModel(GL_FLAT);
        glBegin(run.mode);
        send(run.order);
        glEnd();
        color_of(provoking);
        GLfloat wanted[4];
        glGetFloatv(GL_CURRENT_COLOR, wanted);
        const auto drawn = window.pixels();
        for (const auto& pixel : drawn) {
            if (pixel[3] == 0) continue;
            for (std::size_t k = 0; k < 4; ++k)
                ASSERT_EQ(pixel[k], GLubyte(std::lround(double(wanted[k]) * 255))) << run.mode;
        }
    }
}

TEST(BeginEnd, DropsVerticesThatAreNotFinite) {
    Window window;
    use_pixel_coordinates(window);
    glBegin(GL_POINTS);
    glVertex2f(std::nanf(""), 3);
    glVertex2f(3.5f, 3.5f);
    glVertex4f(1, 1, 1, HUGE_VALF);
    glEnd();
    EXPECT_EQ(window.pixel(3, 3), (std::array<GLubyte, 4>{255, 255, 255, 255}));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// Values that are changed between runs belong to the runs after it, whatever becomes one mesh.
TEST(BeginEnd, KeepsTheStateOfEachRun) {
    Window window;
    use_pixel_coordinates(window);
    const auto point = [](float x) {
        glBegin(GL_POINTS);
        glVertex2f(x + 0.5f, 0.5f);
        glEnd();
    };
    glColor3f(1, 0, 0);
    point(0);
    glColor3f(0, 1, 0);
    point(1);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glColor3f(1, 1, 1);
    point(2);
    glTranslatef(1, 0, 0);
    point(3);
    EXPECT_EQ(window.pixel(0, 0), (std::array<GLubyte, 4>{255, 0, 0, 255}));
    EXPECT_EQ(window.pixel(1, 0), (std::array<GLubyte, 4>{0, 255, 0, 255}));
    EXPECT_EQ(window.pixel(2, 0), (std::array<GLubyte, 4>{255, 0, 255, 255}));
    EXPECT_EQ(window.pixel(3, 0)[3], 0);
    EXPECT_EQ(window.pixel(4, 0), (std::array<GLubyte, 4>{255, 0, 255, 255}));
}

TEST(BeginEnd, HiddenEdgesLeaveLinesOut) {
    const auto lines = [](GLboolean flag) {
        Window window;
        use_pixel_coordinates(window);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glBegin(GL_TRIANGLES);
        glEdgeFlag(flag);
        glVertex2f(2.5f, 2.5f);
        glEdgeFlag(GL_TRUE);
        glVertex2f(28.5f, 2.5f);
        glVertex2f(2.5f, 28.5f);
        glEnd();
        return window.pixel(14, 2)[3];
    };
    EXPECT_EQ(lines(GL_TRUE), 255);
    EXPECT_EQ(lines(GL_FALSE), 0);
}

}  // namespace
}  // namespace gw::gl
