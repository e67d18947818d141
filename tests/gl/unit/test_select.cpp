// Selection and feedback. [GL11] 5.2, 5.3
#include "tests/gl/unit/support/window.h"

namespace gw::gl {
namespace {

/// What feedback of a type gives.
template <class Draw>
std::vector<GLfloat> feedback(GLenum type, Draw draw) {
    std::vector<GLfloat> buffer(1000, -1);
    glFeedbackBuffer(GLsizei(buffer.size()), type, buffer.data());
    glRenderMode(GL_FEEDBACK);
    draw();
    const GLint used = glRenderMode(GL_RENDER);
    EXPECT_GE(used, 0);
    buffer.resize(std::size_t(std::max(used, 0)));
    return buffer;
}
template <class Draw>
std::vector<GLuint> hits(GLint expected, Draw draw) {
    std::vector<GLuint> buffer(80, 0xABCDu);
    glSelectBuffer(GLsizei(buffer.size()), buffer.data());
    glRenderMode(GL_SELECT);
    draw();
    EXPECT_EQ(glRenderMode(GL_RENDER), expected);
    while (!buffer.empty() && buffer.back() == 0xABCDu) buffer.pop_back();
    return buffer;
}

void run(GLenum mode, std::vector<std::array<float, 2>> points) {
    glBegin(mode);
    for (const auto& p : points) glVertex2f(p[0], p[1]);
    glEnd();
}

using Floats = std::vector<GLfloat>;
using Words = std::vector<GLuint>;

}  // namespace

TEST(GlFeedback, TokensOfPointsLinesAndPolygons) {
    const Window window;
    use_pixel_coordinates(window);
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_POINTS, {{3, 4}, {5, 6}});
                       }),
              (Floats{GL_POINT_TOKEN, 3, 4, GL_POINT_TOKEN, 5, 6}));
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_LINES, {{1, 1}, {2, 2}, {3, 3}, {4, 4}});
                       }),
              (Floats{GL_LINE_RESET_TOKEN, 1, 1, 2, 2, GL_LINE_RESET_TOKEN, 3, 3, 4, 4}));
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_LINE_STRIP, {{1, 1}, {2, 2}, {3, 3}});
                       }),
              (Floats{GL_LINE_RESET_TOKEN, 1, 1, 2, 2, GL_LINE_TOKEN, 2, 2, 3, 3}));
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_LINE_LOOP, {{1, 1}, {2, 2}, {3, 1}});
                       }),
              (Floats{GL_LINE_RESET_TOKEN, 1, 1, 2, 2, GL_LINE_TOKEN, 2, 2, 3, 1, GL_LINE_TOKEN, 3,
                      1, 1, 1}));
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_POLYGON, {{1, 1}, {4, 1}, {4, 4}, {1, 4}});
                       }),
              (Floats{GL_POLYGON_TOKEN, 4, 1, 1, 4, 1, 4, 4, 1, 4}));
}

/// [GL11] 2.6.1: quad i of a strip has the vertices 2i - 1, 2i, 2i + 2, 2i + 1. Its colour is that of
/// vertex 2i + 2. Table 2.12
TEST(GlFeedback, QuadsOfStripsBeginWithTheirFirstCorner) {
    const Window window;
    use_pixel_coordinates(window);
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_QUAD_STRIP, {{1, 1}, {1, 4}, {4, 1}, {4, 4}, {7, 1}, {7, 4}});
                       }),
              (Floats{GL_POLYGON_TOKEN, 4, 1, 1, 1, 4, 4, 4, 4, 1,  //
                      GL_POLYGON_TOKEN, 4, 4, 1, 4, 4, 7, 4, 7, 1}));
    glShadeModel(GL_FLAT);
    const Floats flat = feedback(GL_3D_COLOR, [] {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i < 4; ++i) {
            glColor3f(i == 3, 0, 0);
            glVertex2i(1 + 3 * (i / 2), 1 + 3 * (i % 2));
        }
        glEnd();
    });
    ASSERT_EQ(flat.size(), 2u + 4 * 7);
    for (std::size_t corner = 0; corner < 4; ++corner) EXPECT_EQ(flat[2 + 7 * corner + 3], 1);
}

TEST(GlFeedback, LineStripsOfListsBeginOnce) {
    const Window window;
    use_pixel_coordinates(window);
    const auto strip = [] {
        glBegin(GL_LINE_STRIP);
        for (int i = 0; i < 40; ++i) glVertex2f(float(i % 30), float(i % 7));
        glEnd();
    };
    glNewList(1, GL_COMPILE);
    strip();
    glEndList();
    const Floats played = feedback(GL_2D, [] { glCallList(1); });
    EXPECT_EQ(played, feedback(GL_2D, strip));
    EXPECT_EQ(played.size(), 39u * 5);
}

TEST(GlFeedback, ValuesOfEachType) {
    const Window window;
    use_pixel_coordinates(window);
    const auto point = [] {
        glColor4f(1, 0, 1, 0);
        glTexCoord4f(1, 2, 3, 4);
        glBegin(GL_POINTS);
        glVertex3f(3, 4, -0.5f);
        glEnd();
    };
    EXPECT_EQ(feedback(GL_2D, point), (Floats{GL_POINT_TOKEN, 3, 4}));
    EXPECT_EQ(feedback(GL_3D, point), (Floats{GL_POINT_TOKEN, 3, 4, 0.75f}));
    EXPECT_EQ(feedback(GL_3D_COLOR, point), (Floats{GL_POINT_TOKEN, 3, 4, 0.75f, 1, 0, 1, 0}));
    EXPECT_EQ(feedback(GL_3D_COLOR_TEXTURE, point),
              (Floats{GL_POINT_TOKEN, 3, 4, 0.75f, 1, 0, 1, 0, 1, 2, 3, 4}));
    EXPECT_EQ(feedback(GL_4D_COLOR_TEXTURE, point),
              (Floats{GL_POINT_TOKEN, 3, 4, 0.75f, 1, 1, 0, 1, 0, 1, 2, 3, 4}));
}

TEST(GlFeedback, TextureCoordinatesVaryAndTakeTheTextureMatrixWithoutATexture) {
    const Window window;
    use_pixel_coordinates(window);
    glMatrixMode(GL_TEXTURE);
    glScalef(2, 3, 1);
    const auto points = [] {
        glBegin(GL_POINTS);
        glTexCoord2f(1, 1);
        glVertex2f(3, 4);
        glTexCoord2f(2, 5);
        glVertex2f(5, 6);
        glEnd();
    };
    EXPECT_EQ(feedback(GL_3D_COLOR_TEXTURE, points),
              (Floats{GL_POINT_TOKEN, 3, 4, 0.5f, 1, 1, 1, 1, 2, 3,  0, 1,
                      GL_POINT_TOKEN, 5, 6, 0.5f, 1, 1, 1, 1, 4, 15, 0, 1}));
    glTexCoord2f(3, 2);
    glRasterPos2f(1, 1);
    std::array<GLfloat, 4> raster{};
    glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, raster.data());
    EXPECT_EQ(raster, (std::array{6.0f, 6.0f, 0.0f, 1.0f}));
}

TEST(GlFeedback, PrimitivesAreClippedAndCulled) {
    const Window window;
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 32, 0, 32, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    const double left_half[] = {-1, 0, 0, 4};  // x <= 4
    glClipPlane(GL_CLIP_PLANE0, left_half);
    glEnable(GL_CLIP_PLANE0);
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_LINES, {{0, 2}, {8, 2}});
                       }),
              (Floats{GL_LINE_RESET_TOKEN, 0, 2, 4, 2}));
    EXPECT_EQ(feedback(GL_2D, [] { run(GL_POINTS, {{5, 5}}); }), Floats{});
    glDisable(GL_CLIP_PLANE0);
    glEnable(GL_CULL_FACE);
    EXPECT_EQ(feedback(GL_2D, [] { run(GL_TRIANGLES, {{1, 1}, {1, 4}, {4, 1}}); }), Floats{});
    EXPECT_EQ(feedback(GL_2D, [] { run(GL_TRIANGLES, {{1, 1}, {4, 1}, {1, 4}}); }).size(), 8u);
}

TEST(GlFeedback, PrimitivesAreClippedAtTheSidesOfTheViewVolume) {
    const Window window;
    use_pixel_coordinates(window);
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_LINES, {{-16, 2}, {48, 2}});
                       }),
              (Floats{GL_LINE_RESET_TOKEN, 0, 2, 32, 2}));
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_POINTS, {{8, 33}, {33, 8}, {-1, 8}, {8, -1}});
                       }),
              Floats{});
    EXPECT_EQ(feedback(GL_2D,
                       [] {
                           run(GL_POLYGON, {{4, 4}, {40, 4}, {40, 40}, {4, 40}});
                       }),
              (Floats{GL_POLYGON_TOKEN, 4, 4, 4, 32, 4, 32, 32, 4, 32}));
}

TEST(GlFeedback, PolygonModeGivesPointsAndLines) {
    const Window window;
    use_pixel_coordinates(window);
    const auto triangle = [] { run(GL_TRIANGLES, {{1, 1}, {4, 1}, {1, 4}}); };
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    EXPECT_EQ(feedback(GL_2D, triangle),
              (Floats{GL_POINT_TOKEN, 1, 1, GL_POINT_TOKEN, 4, 1, GL_POINT_TOKEN, 1, 4}));
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_EQ(feedback(GL_2D, triangle), (Floats{GL_LINE_RESET_TOKEN, 1, 1, 4, 1, GL_LINE_TOKEN, 4,
                                                 1, 1, 4, GL_LINE_TOKEN, 1, 4, 1, 1}));
}

/// [GL11] 2.6.2: sides that are no edges leave their lines and points out.
TEST(GlFeedback, PolygonModeLeavesOutWhatIsNoEdge) {
    const Window window;
    use_pixel_coordinates(window);
    const auto triangle = [] {
        glBegin(GL_TRIANGLES);
        glEdgeFlag(GL_FALSE);
        glVertex2f(1, 1);
        glEdgeFlag(GL_TRUE);
        glVertex2f(4, 1);
        glVertex2f(1, 4);
        glEnd();
    };
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    EXPECT_EQ(feedback(GL_2D, triangle), (Floats{GL_POINT_TOKEN, 4, 1, GL_POINT_TOKEN, 1, 4}));
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_EQ(feedback(GL_2D, triangle),
              (Floats{GL_LINE_RESET_TOKEN, 4, 1, 1, 4, GL_LINE_TOKEN, 1, 4, 1, 1}));
}

/// Each side is clipped on its own, as the machine draws it: the volume's sides are no lines.
TEST(GlFeedback, PolygonModeClipsEachSide) {
    const Window window;
    use_pixel_coordinates(window);
    const auto triangle = [] { run(GL_TRIANGLES, {{-8, 8}, {8, 0}, {8, 16}}); };
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EXPECT_EQ(feedback(GL_2D, triangle), (Floats{GL_LINE_RESET_TOKEN, 0, 4, 8, 0, GL_LINE_TOKEN, 8,
                                                 0, 8, 16, GL_LINE_TOKEN, 8, 16, 0, 12}));
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    EXPECT_EQ(feedback(GL_2D, triangle), (Floats{GL_POINT_TOKEN, 8, 0, GL_POINT_TOKEN, 8, 16}));
}

TEST(GlFeedback, PixelsAndPassThroughHaveTokens) {
    const Window window;
    use_pixel_coordinates(window);
    const GLubyte pixel[4] = {};
    EXPECT_EQ(feedback(GL_2D,
                       [&] {
                           glPassThrough(7.5f);
                           glRasterPos2f(3, 4);
                           glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
                           glCopyPixels(0, 0, 1, 1, GL_COLOR);
                           glBitmap(1, 1, 0, 0, 2, 3, pixel);
                           glBitmap(0, 0, 0, 0, 0, 0, nullptr);
                       }),
              (Floats{GL_PASS_THROUGH_TOKEN, 7.5f, GL_DRAW_PIXEL_TOKEN, 3, 4, GL_COPY_PIXEL_TOKEN,
                      3, 4, GL_BITMAP_TOKEN, 3, 4, GL_BITMAP_TOKEN, 5, 7}));
}

TEST(GlFeedback, OverflowIsMinusOneAndWritesNothingBeyond) {
    const Window window;
    use_pixel_coordinates(window);
    std::array<GLfloat, 6> buffer{};
    buffer[4] = buffer[5] = 99;
    glFeedbackBuffer(4, GL_2D, buffer.data());
    glRenderMode(GL_FEEDBACK);
    run(GL_POINTS, {{3, 4}, {5, 6}});
    EXPECT_EQ(glRenderMode(GL_RENDER), -1);
    EXPECT_EQ(buffer, (std::array<GLfloat, 6>{GL_POINT_TOKEN, 3, 4, GL_POINT_TOKEN, 99, 99}));
}

TEST(GlSelection, RecordsHoldNamesAndDepths) {
    const Window window;
    use_pixel_coordinates(window);
    const Words records = hits(2, [] {
        glInitNames();
        glPushName(7);
        glPushName(8);
        glBegin(GL_LINES);
        glVertex3f(1, 1, 1);
        glVertex3f(2, 2, -1);
        glEnd();
        glLoadName(9);
        run(GL_POINTS, {{50, 50}});  // outside: no hit
        glPopName();
        run(GL_POINTS, {{5, 5}});
    });
    ASSERT_EQ(records.size(), 5u + 4u);
    EXPECT_EQ(Words(records.begin(), records.begin() + 5), (Words{2, 0, 0xFFFFFFFFu, 7, 8}));
    EXPECT_EQ(records[5], 1u);
    EXPECT_EQ(records[6], 0x80000000u);  // a half of 2^32 - 1, to nearest
    EXPECT_EQ(records[7], 0x80000000u);
    EXPECT_EQ(records[8], 7u);
}

/// [GL11] 2.5: they have no effect, so the hits before and after belong to one record.
TEST(GlSelection, NamesThatAreErrorsWriteNoRecord) {
    const Window window;
    use_pixel_coordinates(window);
    const auto point = [] { run(GL_POINTS, {{5, 5}}); };
    EXPECT_EQ(hits(1,
                   [&] {
                       point();
                       glLoadName(4);
                       point();
                       glPopName();
                       point();
                   }),
              (Words{0, 0x80000000u, 0x80000000u}));
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    hits(1, [&] {
        for (GLuint name = 0; name < 64; ++name) glPushName(name);
        point();
        glPushName(64);
        point();
    });
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
}

TEST(GlSelection, DrawsNothingAndIgnoresNamesOutside) {
    const Window window;
    use_pixel_coordinates(window);
    const auto before = window.pixels();
    EXPECT_EQ(hits(1, [] { glRecti(0, 0, 20, 20); }).size(), 3u);
    EXPECT_EQ(window.pixels(), before);
    glPopName();
    glLoadName(3);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlSelection, ARasterPositionIsAHit) {
    const Window window;
    use_pixel_coordinates(window);
    EXPECT_EQ(hits(1, [] { glRasterPos2f(3, 4); }).size(), 3u);
    EXPECT_EQ(hits(0, [] { glRasterPos2f(-3, 4); }).size(), 0u);
}

TEST(GlSelection, NameStackHasSixtyFourEntries) {
    const Window window;
    hits(0, [] {
        glLoadName(1);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
        glPopName();
        EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
        for (GLuint i = 0; i < 64; ++i) glPushName(i);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        glPushName(64);
        EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
    });
}

TEST(GlSelection, OverflowIsMinusOne) {
    const Window window;
    use_pixel_coordinates(window);
    std::array<GLuint, 4> buffer{1, 1, 1, 77};
    glSelectBuffer(3, buffer.data());
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(5);
    run(GL_POINTS, {{3, 4}});
    EXPECT_EQ(glRenderMode(GL_RENDER), -1);
    EXPECT_EQ(buffer[3], 77u);
}

TEST(GlSelection, ModesNeedTheirBuffers) {
    const Window window;
    glRenderMode(GL_SELECT);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glRenderMode(GL_FEEDBACK);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glRenderMode(GL_COMPILE);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    std::array<GLuint, 4> buffer{};
    glSelectBuffer(4, buffer.data());
    glRenderMode(GL_SELECT);
    glSelectBuffer(4, buffer.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    glRenderMode(GL_RENDER);
}

/// [GL11] 5.2, 5.3: a mode needs that its buffer was given once, of whatever size.
TEST(GlSelection, BuffersOfNoMemoryOverflow) {
    const Window window;
    use_pixel_coordinates(window);
    glSelectBuffer(0, nullptr);
    glFeedbackBuffer(0, GL_2D, nullptr);
    for (const GLenum mode : {GL_SELECT, GL_FEEDBACK}) {
        glRenderMode(mode);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        EXPECT_EQ(glRenderMode(mode), 0);  // nothing was drawn
        run(GL_POINTS, {{3, 4}});
        EXPECT_EQ(glRenderMode(GL_RENDER), -1);
    }
}

}  // namespace gw::gl
