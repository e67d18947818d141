// Programs that misuse GL: an error, never a crash, and the context goes on working.
#include "tests/gl/unit/support/picture.h"

#include <limits>
#include <thread>

namespace gw::gl {
namespace {

constexpr GLint largest = std::numeric_limits<GLint>::max();

/// A context of its own, and its last weak references.
struct Watched {
    std::weak_ptr<TextureObject> texture;
    std::weak_ptr<const DisplayList> list;
};

void expect_works(const Window& window) {
    while (glGetError() != GL_NO_ERROR) {
    }
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(window.pixel(5, 5), (std::array<GLubyte, 4>{255, 0, 0, 255}));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

void point_at(GLfloat x) {
    glBegin(GL_POINTS);
    glVertex2f(x, 1);
    glEnd();
}

}  // namespace

TEST(GlHostile, ImagesBeyondEveryMemoryAreErrors) {
    const Window window;
    const GLubyte nothing = 0;
    for (const GLsizei size : {largest, 1 << 30, 1 << 16, -1, -largest}) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_FLOAT, &nothing);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE)) << size;
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, size, 0, GL_RGBA, GL_FLOAT, &nothing);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE)) << size;
        glDrawPixels(size, size, GL_RGBA, GL_FLOAT, nullptr);
        glBitmap(size, size, 0, 0, 0, 0, nullptr);
        glCopyPixels(0, 0, size, size, GL_COLOR);
        EXPECT_EQ(glGetError(), GLenum(size < 0 ? GL_INVALID_VALUE : GL_NO_ERROR)) << size;
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, size, size, 0);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE)) << size;
    }
    expect_works(window);
}

TEST(GlHostile, AnImageOfMoreBytesThanThereAreIsNotRead) {
    const Window window;
    glDrawPixels(largest, largest, GL_RGBA, GL_FLOAT, &window);
    EXPECT_EQ(glGetError(), GLenum(GL_OUT_OF_MEMORY));
    expect_works(window);
}

TEST(GlHostile, CopiesFromFarOutsideTheWindowAreTaken) {
    const Window window;
    for (const GLint at : {largest, -largest - 1, 1 << 20, -5000}) {
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, at, at, 4, 4, 0);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, at, at, 4, 4);
        glCopyPixels(at, at, 4, 4, GL_COLOR);
        std::array<GLubyte, 64> pixels{};
        glReadPixels(at, at, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        glScissor(at, at, 4, 4);
        glViewport(at, at, 4, 4);
        glRecti(-1, -1, 1, 1);
    }
    expect_works(window);
}

TEST(GlHostile, ARecursiveListEndsAtTheDepthOfNesting) {
    const Window window;
    glNewList(3, GL_COMPILE);
    glTranslatef(1, 0, 0);
    glCallList(3);
    glEndList();
    glCallList(3);
    std::array<GLfloat, 16> matrix{};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], 64.0f);
    expect_works(window);
}

TEST(GlHostile, AListMayDeleteOrReplaceItselfWhileItIsPlayed) {
    const Window window;
    const auto delete_itself = [] { glDeleteLists(3, 1); };
    glNewList(3, GL_COMPILE);
    glTranslatef(1, 0, 0);
    glCallList(4);
    glTranslatef(2, 0, 0);
    glEndList();
    glNewList(4, GL_COMPILE);
    glEndList();
    glCallList(3);
    delete_itself();
    glCallList(3);
    std::array<GLfloat, 16> matrix{};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], 3.0f);
    // While list 3 is open, its old content is played; EndList replaces it.
    glNewList(3, GL_COMPILE_AND_EXECUTE);
    glCallList(3);
    glTranslatef(10, 0, 0);
    glEndList();
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    EXPECT_EQ(matrix[12], 13.0f);
    expect_works(window);
}

TEST(GlHostile, NamesOfListsOfEveryTypeAndAnyOffset) {
    const Window window;
    std::array<GLubyte, 64> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = GLubyte(i * 37);
    for (GLuint base : {0u, 1u, ~0u, 0x80000000u}) {
        glListBase(base);
        for (GLenum type = GL_BYTE - 2; type <= GL_4_BYTES + 2; ++type)
            glCallLists(9, type, bytes.data() + 1);
    }
    glCallLists(-1, GL_BYTE, bytes.data());
    glCallLists(largest, GL_BYTE, nullptr);
    glDeleteLists(~0u, largest);
    glDeleteLists(1, largest);
    expect_works(window);
}

TEST(GlHostile, NumbersThatAreNoNumbersDrawNothing) {
    const Window window;
    const GLfloat nan = std::numeric_limits<GLfloat>::quiet_NaN();
    const GLfloat inf = std::numeric_limits<GLfloat>::infinity();
    for (const GLfloat bad : {nan, inf, -inf, 1e38f}) {
        glRasterPos4f(bad, bad, bad, bad);
        const GLubyte bits = 0xFF;
        glBitmap(8, 1, bad, bad, bad, bad, &bits);
        glPixelZoom(bad, bad);
        glDrawPixels(1, 1, GL_RED, GL_UNSIGNED_BYTE, &bits);
        glPixelZoom(1, 1);
        glLineWidth(bad);
        glPointSize(bad);
        glPolygonOffset(bad, bad);
        glDepthRange(GLclampd(bad), GLclampd(bad));
        glRotatef(bad, bad, bad, bad);
        glFogf(GL_FOG_DENSITY, bad);
        point_at(bad);
        glMapGrid2f(3, bad, bad, 3, bad, bad);
        glEvalMesh2(GL_FILL, 0, 3, 0, 3);
        glClearColor(bad, bad, bad, bad);
        glClearAccum(bad, bad, bad, bad);
        glClearDepth(GLclampd(bad));
        glClear(GL_COLOR_BUFFER_BIT | GL_ACCUM_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glAccum(GL_MULT, bad);
        glAccum(GL_RETURN, bad);
    }
    expect_works(window);
}

/// Products that leave float, and for clip planes double.
TEST(GlHostile, WhatMatricesTakeBeyondTheNumbersIsDrawnWith) {
    const Window window;
    for (int i = 0; i < 8; ++i) glScaled(1e-38, 1, 1);
    const GLdouble plane[] = {1e38, 0, 0, 0};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glTexGendv(GL_S, GL_EYE_PLANE, plane);
    glLoadIdentity();
    glScaled(1e38, 1e38, 1e38);
    const GLfloat far_away[] = {1e38f, 1e38f, 1e38f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, far_away);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, far_away);
    glLoadIdentity();
    glMatrixMode(GL_TEXTURE);
    glScaled(1e38, 1e38, 1e38);
    glTexCoord2f(1e38f, 1e38f);
    glMatrixMode(GL_MODELVIEW);
    glRasterPos2f(0, 0);

    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const GLenum what : {GL_LIGHTING, GL_LIGHT0, GL_TEXTURE_GEN_S}) glEnable(what);
    point_at(2);
    const GLubyte bits = 0xFF;
    glBitmap(8, 1, 0, 0, 0, 0, &bits);
    EXPECT_EQ(window.pixel(5, 5), (std::array<GLubyte, 4>{255, 0, 0, 255}));
}

TEST(GlHostile, FogOfNoDensityOrNoRangeIsDrawn) {
    const Window window;
    const GLfloat blue[] = {0, 0, 1, 1};
    glFogfv(GL_FOG_COLOR, blue);
    glEnable(GL_FOG);
    glClearColor(1, 0, 0, 1);
    const auto drawn_with = [&](GLenum mode, GLenum name, GLfloat value) {
        glFogi(GL_FOG_MODE, GLint(mode));
        glFogf(name, value);
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1, -1, 1, 1);
        return window.pixel(5, 5);
    };
    constexpr std::array<GLubyte, 4> white{255, 255, 255, 255}, fog{0, 0, 255, 255};
    EXPECT_EQ(drawn_with(GL_EXP, GL_FOG_DENSITY, 0), white);
    EXPECT_EQ(drawn_with(GL_EXP2, GL_FOG_DENSITY, 0), white);
    glFogf(GL_FOG_START, 1);
    EXPECT_EQ(drawn_with(GL_LINEAR, GL_FOG_END, 1), white);
    glFogf(GL_FOG_START, 0);
    EXPECT_EQ(drawn_with(GL_LINEAR, GL_FOG_END, 0), fog);
}

TEST(GlHostile, ElementsOfNoArraysHaveAnyNumber) {
    const Window window;
    glDrawArrays(GL_POINTS, largest, 3);
    glArrayElement(largest);
    const GLuint index = ~0u;
    glDrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, &index);
    glDrawElements(GL_POINTS, -1, GL_UNSIGNED_INT, &index);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    expect_works(window);
}

TEST(GlHostile, AContextMayEndWhileItIsCurrentWithEverythingOpen) {
    Drawable drawable(opengl(), 16, 16, "window", Buffers::Single);
    {
        Context context(opengl());
        make_current(&context, &drawable);
        std::array<GLfloat, 8> feedback{};
        glFeedbackBuffer(8, GL_2D, feedback.data());
        glRenderMode(GL_FEEDBACK);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glNewList(1, GL_COMPILE_AND_EXECUTE);
        glBegin(GL_TRIANGLES);
        glVertex2f(0, 0);
        make_current(nullptr, nullptr);
    }
    const Window window;
    expect_works(window);
}

TEST(GlHostile, ObjectsAreFreedWithTheLastContextThatSharesThem) {
    Watched watched;
    auto first = std::make_unique<Context>(opengl());
    make_current(first.get(), nullptr);
    glBindTexture(GL_TEXTURE_2D, 5);
    const GLubyte texel[4] = {};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glNewList(5, GL_COMPILE);
    point_at(1);
    glEndList();
    watched.texture = first->shared->textures.named[5].object;
    watched.list = first->shared->lists.lists[5];
    auto second = std::make_unique<Context>(opengl(), first->shared);
    make_current(nullptr, nullptr);
    first.reset();
    EXPECT_FALSE(watched.texture.expired());
    EXPECT_FALSE(watched.list.expired());
    make_current(second.get(), nullptr);
    glDeleteLists(5, 1);
    EXPECT_TRUE(watched.list.expired());
    make_current(nullptr, nullptr);
    second.reset();
    EXPECT_TRUE(watched.texture.expired());
}

TEST(GlHostile, MeshesOfADeletedListAreFreed) {
    const Window window;
    glNewList(5, GL_COMPILE);
    glBegin(GL_POINTS);
    for (int i = 0; i < 100; ++i) glVertex2f(0, 0);
    glEnd();
    glEndList();
    const std::weak_ptr<const DisplayList> list = window.context.shared->lists.lists[5];
    glCallList(5);
    glFinish();
    glDeleteLists(5, 1);
    EXPECT_TRUE(list.expired());
}

TEST(GlHostile, ThreadsWithSharedObjectsDoNotDisturbEachOther) {
    const auto shared = std::make_shared<Shared>();
    const auto run = [&](GLuint seed) {
        Context context(opengl(), shared);
        Drawable drawable(opengl(), 16, 16, "window", Buffers::Single);
        make_current(&context, &drawable);
        const std::array<GLubyte, 16> texels{};
        for (GLuint i = 0; i < 200; ++i) {
            const GLuint name = 1 + (seed + i) % 5;
            glNewList(name, GL_COMPILE);
            point_at(GLfloat(i % 7));
            glEndList();
            glCallList(1 + i % 5);
            glDeleteLists(1 + (i + 2) % 5, 1);
            glBindTexture(GL_TEXTURE_2D, 10 + seed);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texels.data());
            glBindTexture(GL_TEXTURE_2D, 0);
            const GLuint other = 10 + (seed + 1) % 3;
            glDeleteTextures(1, &other);
            glIsTexture(other);
        }
        glFinish();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        make_current(nullptr, nullptr);
    };
    std::vector<std::thread> threads;
    for (GLuint seed = 0; seed < 3; ++seed) threads.emplace_back(run, seed);
    for (std::thread& thread : threads) thread.join();
}

}  // namespace gw::gl
