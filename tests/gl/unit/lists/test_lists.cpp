// Display lists play what immediate mode draws, bit for bit. [GL11] 5.4
#include "tests/gl/unit/support/picture.h"
#include "tests/gl/unit/support/snapshot.h"

#include <cmath>

namespace gw::gl {
namespace {

/// Vertices on a spiral, so that every mode draws something.
void spiral(int count, float radius = 14) {
    for (int i = 0; i < count; ++i) {
        const float r = radius * float(i + 3) / float(count + 3), a = float(i) * 1.7f;
        glVertex3f(16 + r * std::cos(a), 16 + r * std::sin(a), 0.25f);
    }
}

void colored_runs(GLenum mode) {
    glBegin(mode);
    glColor3f(1, 0, 0);
    glVertex2f(2, 3);
    glColor3f(0, 1, 0);
    glVertex2f(29, 4);
    glTexCoord2f(1, 1);
    glVertex2f(27, 28);
    glColor3f(0, 0, 1);
    glEdgeFlag(GL_FALSE);
    glNormal3f(0, 1, 0);
    glVertex2f(3, 25);
    glEnd();
}
template <GLenum mode>
void all_values() {
    colored_runs(mode);
}
template <GLenum mode>
void positions_only() {
    glBegin(mode);
    spiral(11);
    glEnd();
}
template <GLenum mode>
void incomplete() {
    for (int count = 1; count < 8; ++count) {
        glBegin(mode);
        spiral(count, 4 + float(count));
        glEnd();
    }
}
template <GLenum mode>
void outlines() {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glBegin(mode);
    for (int i = 0; i < 12; ++i) {
        glEdgeFlag(i % 3 != 0);
        glVertex2f(16 + 13 * std::cos(float(i)), 16 + 13 * std::sin(float(i)));
    }
    glEnd();
}
void materials_inside() {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 6; ++i) {
        const float diffuse[] = {float(i % 2), float(i % 3) / 2, 0.5f, 1};
        if (i != 2) glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
        glVertex2f(i % 3 == 1 ? 30 : 2, float(5 * i + 2));
    }
    glEnd();
}
void state_between() {
    for (int i = 0; i < 4; ++i) {
        glPushMatrix();
        glTranslatef(float(2 * i), float(i), 0);
        glRotatef(float(20 * i), 0, 0, 1);
        if (i == 2) glEnable(GL_DEPTH_TEST);
        glColor3ub(GLubyte(60 * i), 200, 30);
        glRecti(3, 3, 12, 9);
        glPopMatrix();
    }
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(20, 20, 5, 5);
    glClearColor(1, 0.5f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glPopAttrib();
}
void pixels() {
    std::array<GLubyte, 4 * 64> image{};
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = GLubyte(i * 37);
    glRasterPos2i(3, 4);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    glPixelZoom(1.5f, 2);
    glRasterPos2i(14, 12);
    glCopyPixels(3, 4, 6, 6, GL_COLOR);
    glColor3f(1, 1, 0);
    glRasterPos2i(1, 20);
    for (int i = 0; i < 3; ++i) glBitmap(8, 8, 0, 0, 9, 1, image.data());
    image.fill(0);  // a list has read the pixels
}
void texture() {
    std::array<GLubyte, 4 * 16> image{};
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = GLubyte(i * 91);
    glBindTexture(GL_TEXTURE_2D, 3);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    image.fill(0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
        const float x = i == 1 || i == 2, y = i > 1;
        glTexCoord2f(x * 2, y);
        glVertex2f(2 + 27 * x, 3 + 25 * y);
    }
    glEnd();
}
void arrays() {
    float vertices[24];
    GLubyte colors[36];
    for (int i = 0; i < 12; ++i) {
        vertices[2 * i] = 16 + float(i + 2) * std::cos(float(i));
        vertices[2 * i + 1] = 16 + float(i + 2) * std::sin(float(i));
        for (int k = 0; k < 3; ++k) colors[3 * i + k] = GLubyte(83 * i + 50 * k);
    }
    glVertexPointer(2, GL_FLOAT, 0, vertices);
    glColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glDrawArrays(GL_TRIANGLES, 0, 12);
    const GLushort indices[] = {3, 1, 7, 9, 11, 0};
    glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_SHORT, indices);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < 12; i += 2) glArrayElement(i);
    glEnd();
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    std::fill(vertices, vertices + 24, 0.0f);
}
void evaluators() {
    const float points[] = {2, 2, 0, 8, 30, 0, 20, 0, 0, 30, 29, 0};
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points);
    glEnable(GL_MAP1_VERTEX_3);
    glMapGrid1f(17, 0, 1);
    glEvalMesh1(GL_LINE, 0, 17);
    glBegin(GL_POINTS);
    for (int i = 0; i < 5; ++i) glEvalCoord1f(float(i) / 7);
    glEvalPoint1(5);
    glEnd();
}

struct Content {
    const char* name;
    void (*draw)();
};
template <GLenum mode>
void add_contents(std::vector<Content>& out) {
    out.push_back({"all values", all_values<mode>});
    out.push_back({"positions only", positions_only<mode>});
    out.push_back({"incomplete", incomplete<mode>});
    out.push_back({"outlines", outlines<mode>});
}
std::vector<Content> contents() {
    std::vector<Content> out{{"materials inside", materials_inside},
                             {"state between", state_between},
                             {"pixels", pixels},
                             {"texture", texture},
                             {"arrays", arrays},
                             {"evaluators", evaluators}};
    [&]<GLenum... mode>(std::integer_sequence<GLenum, mode...>) { (add_contents<mode>(out), ...); }
    (std::make_integer_sequence<GLenum, GL_POLYGON + 1>());
    return out;
}

/// A picture and the state that is left.
struct Outcome {
    Picture picture;
    Snapshot state;
};
template <class Draw>
Outcome outcome(Draw draw) {
    const Window window;
    use_pixel_coordinates(window);
    draw();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    return {picture_of(window), snapshot()};
}
template <class Draw>
void compile(GLuint name, Draw draw, GLenum mode = GL_COMPILE) {
    glNewList(name, mode);
    draw();
    glEndList();
}
void expect_same(const Outcome& a, const Outcome& b) {
    EXPECT_EQ(a.picture, b.picture);
    EXPECT_EQ(changes(a.state, b.state), std::vector<std::string>{});
}

}  // namespace

TEST(GlLists, PlayWhatImmediateModeDraws) {
    for (const Content& content : contents()) {
        SCOPED_TRACE(content.name);
        const Outcome immediate = outcome(content.draw);
        EXPECT_NE(immediate.picture, blank());
        expect_same(immediate, outcome([&] {
                        compile(1, content.draw);
                        glCallList(1);
                    }));
        expect_same(immediate, outcome([&] { compile(1, content.draw, GL_COMPILE_AND_EXECUTE); }));
        expect_same(outcome([&] {
                        content.draw();
                        content.draw();
                    }),
                    outcome([&] {
                        compile(1, content.draw, GL_COMPILE_AND_EXECUTE);
                        glCallList(1);
                    }));
    }
}

TEST(GlLists, CompilingDrawsAndChangesNothing) {
    for (const Content& content : contents()) {
        if (content.draw == arrays) continue;  // the client's state changes at once
        SCOPED_TRACE(content.name);
        expect_same(outcome([] {}), outcome([&] { compile(1, content.draw); }));
    }
}

TEST(GlLists, BeginInOneListAndEndInAnother) {
    expect_same(outcome(positions_only<GL_TRIANGLES>), outcome([] {
                    compile(1, [] { glBegin(GL_TRIANGLES); });
                    compile(2, [] { spiral(11); });
                    compile(3, [] { glEnd(); });
                    for (GLuint name = 1; name <= 3; ++name) glCallList(name);
                }));
}

TEST(GlLists, ValuesThatAreNotGivenAreTheCurrentOnes) {
    expect_same(outcome([] {
                    glColor3f(0, 1, 1);
                    positions_only<GL_QUAD_STRIP>();
                    glColor3f(1, 0, 1);
                    glTranslatef(3, 2, 0);
                    positions_only<GL_QUAD_STRIP>();
                }),
                outcome([] {
                    compile(1, positions_only<GL_QUAD_STRIP>);
                    glColor3f(0, 1, 1);
                    glCallList(1);
                    glColor3f(1, 0, 1);
                    glTranslatef(3, 2, 0);
                    glCallList(1);
                }));
}

TEST(GlLists, NestToTheDepthOfSixtyFour) {
    const Window window;
    glEnableClientState(GL_VERTEX_ARRAY);
    for (GLuint name = 1; name <= 70; ++name)
        compile(name, [&] {
            glTranslatef(1, 0, 0);
            glCallList(name + 1);
        });
    glCallList(1);
    std::array<float, 16> matrix{};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], 64);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    // A list that calls itself ends there too.
    glLoadIdentity();
    compile(1, [] {
        glTranslatef(0, 1, 0);
        glCallList(1);
    });
    glCallList(1);
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[13], 64);
}

TEST(GlLists, ErrorsComeWhenTheListIsPlayed) {
    const Window window;
    compile(1, [] {
        glEnable(GL_COMPILE);
        glColor3f(0, 1, 0);
        glPointSize(-1);
    });
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glCallList(1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glCallLists(-1, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glCallLists(1, GL_RGBA, "");
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glNewList(0, GL_COMPILE);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glNewList(1, GL_RENDER);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glEndList();
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glGenLists(-1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glDeleteLists(1, -1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

TEST(GlLists, ACallThatMayNotStandInsideBeginIsAnErrorThereToo) {
    const Window window;
    compile(1, [] {
        glEnable(GL_BLEND);
        glColor3f(0, 1, 0);
    });
    glBegin(GL_POINTS);
    glCallList(1);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsEnabled(GL_BLEND));
    std::array<float, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    EXPECT_EQ(color, (std::array{0.0f, 1.0f, 0.0f, 1.0f}));
}

TEST(GlLists, AreReplacedOnlyWhenTheyEnd) {
    const Window window;
    compile(1, [] { glPointSize(2); });
    float size = 0;
    glNewList(1, GL_COMPILE_AND_EXECUTE);
    glPointSize(5);
    glCallList(1);  // still the old one
    glGetFloatv(GL_POINT_SIZE, &size);
    EXPECT_EQ(size, 2);
    glEndList();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlLists, NamesAreReservedUsedAndDeleted) {
    const Window window;
    EXPECT_EQ(glGenLists(0), 0u);
    const GLuint first = glGenLists(3);
    for (GLuint i = 0; i < 3; ++i) EXPECT_TRUE(glIsList(first + i));
    EXPECT_FALSE(glIsList(first + 3));
    compile(first + 3, [] {});
    const GLuint next = glGenLists(2);
    EXPECT_TRUE(next > first + 3 || next + 1 < first);
    glDeleteLists(first, 4);
    for (GLuint i = 0; i < 4; ++i) EXPECT_FALSE(glIsList(first + i));
    EXPECT_TRUE(glIsList(next + 1));
    glDeleteLists(0, 0x7FFFFFFF);
    EXPECT_FALSE(glIsList(next));
    glCallList(next);  // no list: nothing
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(glGenLists(0x7FFFFFFF), 0u);
    EXPECT_EQ(glGetError(), GLenum(GL_OUT_OF_MEMORY));
}

TEST(GlLists, CallListsReadsNamesOfEveryType) {
    const Window window;
    for (const GLuint offset : {1u, 3u, 7u})
        compile(1000 + offset, [&] { glTranslatef(float(offset), float(offset * offset), 0); });
    const auto expect_played = [](GLsizei n, GLenum type, const void* names) {
        glLoadIdentity();
        glCallLists(n, type, names);
        std::array<float, 16> matrix{};
        glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
        EXPECT_EQ(matrix[12], 11) << type;
        EXPECT_EQ(matrix[13], 59) << type;
    };
    glListBase(1000);
    expect_played(3, GL_BYTE, std::array<GLbyte, 3>{1, 3, 7}.data());
    expect_played(3, GL_UNSIGNED_BYTE, std::array<GLubyte, 3>{1, 3, 7}.data());
    expect_played(3, GL_SHORT, std::array<GLshort, 3>{1, 3, 7}.data());
    expect_played(3, GL_UNSIGNED_SHORT, std::array<GLushort, 3>{1, 3, 7}.data());
    expect_played(3, GL_INT, std::array<GLint, 3>{1, 3, 7}.data());
    expect_played(3, GL_UNSIGNED_INT, std::array<GLuint, 3>{1, 3, 7}.data());
    expect_played(3, GL_FLOAT, std::array<GLfloat, 3>{1.5f, 3, 7.75f}.data());
    expect_played(3, GL_2_BYTES, std::array<GLubyte, 6>{0, 1, 0, 3, 0, 7}.data());
    expect_played(3, GL_3_BYTES, std::array<GLubyte, 9>{0, 0, 1, 0, 0, 3, 0, 0, 7}.data());
    expect_played(3, GL_4_BYTES,
                  std::array<GLubyte, 12>{0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 7}.data());
    glListBase(1010);
    expect_played(3, GL_BYTE, std::array<GLbyte, 3>{-9, -7, -3}.data());
    glListBase(0);
    expect_played(3, GL_2_BYTES, std::array<GLubyte, 6>{3, 233, 3, 235, 3, 239}.data());
    expect_played(3, GL_INT, std::array<GLint, 3>{1001, 1003, 1007}.data());
}

TEST(GlLists, ImagesOfProxiesAreSetAtOnce) {
    const Window window;
    glNewList(1, GL_COMPILE);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 8, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    GLint height = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    glEndList();
    EXPECT_EQ(height, 16);
}

}  // namespace gw::gl
