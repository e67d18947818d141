// Occlusion queries count the fragments that pass. [GL15] 4.1.7
#include "tests/gl/unit/support/window.h"

#include <memory>

namespace gw::gl {

namespace {

GLuint result(GLuint id) {
    GLuint samples = ~0u;
    glGetQueryObjectuiv(id, GL_QUERY_RESULT, &samples);
    return samples;
}

template <class Draw>
GLuint counted(Draw draw) {
    glBeginQuery(GL_SAMPLES_PASSED, 7);
    draw();
    glEndQuery(GL_SAMPLES_PASSED);
    return result(7);
}

void expect_error(GLenum error) { EXPECT_EQ(glGetError(), error); }

}  // namespace

TEST(GlOcclusion, CountsTheFragmentsThatPass) {
    const Window window;
    use_pixel_coordinates(window);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    EXPECT_EQ(counted([] {}), 0u);
    EXPECT_EQ(counted([] { glRecti(0, 0, 16, 16); }), 256u);
    EXPECT_EQ(counted([] { glRecti(8, 0, 24, 16); }), 128u);  // the left half is hidden
    EXPECT_EQ(counted([] {
                  glColorMask(0, 0, 0, 0);
                  glDisable(GL_DEPTH_TEST);
                  glRecti(0, 0, 32, 32);
                  glRecti(0, 0, 1, 1);
              }),
              1025u);
    glRecti(0, 0, 32, 32);  // after the query
    EXPECT_EQ(result(7), 1025u);
}

TEST(GlOcclusion, CountsThroughReadsFlushesListsAndFrames) {
    Window window(32, 32, opengl(), Buffers::Double);
    use_pixel_coordinates(window);
    glNewList(3, GL_COMPILE);
    glBeginQuery(GL_SAMPLES_PASSED, 9);
    glRecti(0, 0, 2, 2);
    glEndList();
    glCallList(3);
    window.pixels();
    glRecti(0, 0, 3, 3);
    glFinish();
    glRecti(0, 0, 1, 1);
    for (int i = 0; i < 20; ++i) {  // animations draw behind
        window.drawable.swap();
        glRecti(0, 0, 2, 1);
    }
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(result(9), 4u + 9 + 1 + 40);
}

/// A context may draw elsewhere meanwhile, and another one to the same drawable.
TEST(GlOcclusion, CountsInEveryDrawable) {
    Window window;
    Context other(opengl());
    Drawable elsewhere(opengl(), 32, 32);
    use_pixel_coordinates(window);
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    glRecti(0, 0, 4, 1);
    make_current(&other, &window.drawable, &window.drawable);
    glBeginQuery(GL_SAMPLES_PASSED, 1);
    glRectf(-1, -1, 1, 1);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(result(1), 1024u);
    make_current(&window.context, &elsewhere, &elsewhere);
    glRecti(0, 0, 3, 1);
    glEndQuery(GL_SAMPLES_PASSED);
    make_current(&window.context, &window.drawable, &window.drawable);
    EXPECT_EQ(result(1), 7u);
}

TEST(GlOcclusion, SurvivesANewSizeOfTheDrawable) {
    Window window;
    use_pixel_coordinates(window);
    EXPECT_EQ(counted([&] {
                  glRecti(0, 0, 2, 1);
                  glEnable(GL_BLEND);  // the square is in the frame, which is dropped
                  window.drawable.resize(16, 16);
                  glRecti(0, 0, 4, 4);
              }),
              16u);
}

/// Blits and texels that become planes are not drawn. GL_ARB_framebuffer_object, 4.3.3
TEST(GlOcclusion, DoesNotCountWhatIsOnlyMoved) {
    const Window window;
    const std::vector<GLubyte> white(4 * 4 * 4, 255);
    glBindTexture(GL_TEXTURE_2D, 3);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    glBindFramebufferEXT(GL_FRAMEBUFFER, 3);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 3, 0);
    EXPECT_EQ(counted([] { glRectf(-1, -1, 1, 1); }), 16u) << "with texels moved first";
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    EXPECT_EQ(counted([] {
                  glRectf(-1, -1, 1, 1);
                  glBlitFramebuffer(0, 0, 4, 4, 0, 0, 20, 20, GL_COLOR_BUFFER_BIT, GL_NEAREST);
                  glRectf(-1, -1, 1, 1);
              }),
              2048u);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlOcclusion, ResultsAreWholeAndAvailable) {
    const Window window;
    glBeginQuery(GL_SAMPLES_PASSED, 4);
    glRectf(-1, -1, 1, 1);
    glEndQuery(GL_SAMPLES_PASSED);
    GLint available = 0, samples = 0, bits = 0;
    glGetQueryObjectiv(4, GL_QUERY_RESULT_AVAILABLE, &available);
    glGetQueryObjectivARB(4, GL_QUERY_RESULT, &samples);
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    EXPECT_EQ(available, GL_TRUE);
    EXPECT_EQ(samples, 1024);
    EXPECT_EQ(bits, 64);
}

TEST(GlOcclusion, NamesAreThoseOfQueriesOnceTheyBegin) {
    const Window window;
    GLuint ids[2] = {};
    glGenQueries(2, ids);
    EXPECT_NE(ids[0], ids[1]);
    EXPECT_FALSE(glIsQuery(ids[0]));
    glBeginQuery(GL_SAMPLES_PASSED, ids[0]);
    EXPECT_TRUE(glIsQuery(ids[0]));
    GLint current = 0;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    EXPECT_EQ(GLuint(current), ids[0]);
    glEndQuery(GL_SAMPLES_PASSED);
    glDeleteQueries(2, ids);
    EXPECT_FALSE(glIsQuery(ids[0]));
    expect_error(GL_NO_ERROR);
    EXPECT_EQ(result(ids[0]), ~0u);
    expect_error(GL_INVALID_OPERATION);
}

TEST(GlErrors, OfOcclusionQueries) {
    const Window window;
    GLuint id = 5;
    GLint value = 0;
    glBeginQuery(GL_SAMPLES, id);
    expect_error(GL_INVALID_ENUM);
    glBeginQuery(GL_SAMPLES_PASSED, 0);
    expect_error(GL_INVALID_OPERATION);
    glEndQuery(GL_SAMPLES_PASSED);
    expect_error(GL_INVALID_OPERATION);
    glGenQueries(-1, &id);
    expect_error(GL_INVALID_VALUE);
    glDeleteQueries(-1, &id);
    expect_error(GL_INVALID_VALUE);
    glGetQueryiv(GL_SAMPLES_PASSED, GL_SAMPLES, &value);
    expect_error(GL_INVALID_ENUM);
    glGetQueryObjectiv(5, GL_QUERY_RESULT, &value);
    expect_error(GL_INVALID_OPERATION);  // no query yet
    glBeginQuery(GL_SAMPLES_PASSED, id);
    for (const auto call :
         {+[](GLuint* i) { glGenQueries(1, i); }, +[](GLuint* i) { glDeleteQueries(1, i); },
          +[](GLuint*) { glBeginQuery(GL_SAMPLES_PASSED, 6); }, +[](GLuint* i) { result(*i); }}) {
        call(&id);
        expect_error(GL_INVALID_OPERATION);  // while one is active
    }
    glEndQuery(GL_SAMPLES);
    expect_error(GL_INVALID_ENUM);
    glBegin(GL_POINTS);
    glEndQuery(GL_SAMPLES_PASSED);
    glEnd();
    expect_error(GL_INVALID_OPERATION);
    glEndQuery(GL_SAMPLES_PASSED);
    expect_error(GL_NO_ERROR);
    glGetQueryObjectiv(id, GL_SAMPLES, &value);
    expect_error(GL_INVALID_ENUM);
}

/// [GL15] 4.1.7: a counter of 0 bits counts nothing.
TEST(GlOcclusion, AProfileWithoutQueriesHasACounterOfNoBits) {
    const Window window(8, 8, vgx());
    GLint bits = 1;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    EXPECT_EQ(bits, 0);
    EXPECT_EQ(counted([] { glRectf(-1, -1, 1, 1); }), 0u);
}

}  // namespace gw::gl
