// Front and back buffer, draw and read buffer, clears and the accumulation buffer. [GL11] 4.2, 4.3.2
#include "tests/gl/unit/support/window.h"

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;
constexpr Color black{0, 0, 0, 0}, red{255, 0, 0, 255}, green{0, 255, 0, 255};

struct DoubleBuffered : Window {
    explicit DoubleBuffered(const Profile& profile = opengl())
        : Window(8, 8, profile, Buffers::Double) {}
};

void clear_to(const Color& color) {
    glClearColor(GLfloat(color[0]) / 255, GLfloat(color[1]) / 255, GLfloat(color[2]) / 255,
                 GLfloat(color[3]) / 255);
    glClear(GL_COLOR_BUFFER_BIT);
}

Color pixel_of(const Window& window, GLenum buffer) {
    glReadBuffer(buffer);
    return window.pixel(3, 3);
}

TEST(Buffers, ArePrescribedByTheKindOfDrawable) {
    const auto initial = [](Buffers buffers) {
        const Window window(8, 8, opengl(), buffers);
        std::array<GLint, 3> values{};
        glGetIntegerv(GL_DRAW_BUFFER, &values[0]);
        glGetIntegerv(GL_READ_BUFFER, &values[1]);
        glGetIntegerv(GL_DOUBLEBUFFER, &values[2]);
        return values;
    };
    EXPECT_EQ(initial(Buffers::Single), (std::array<GLint, 3>{GL_FRONT, GL_FRONT, 0}));
    EXPECT_EQ(initial(Buffers::Double), (std::array<GLint, 3>{GL_BACK, GL_BACK, 1}));
}

/// [GL11] table 4.4: the buffers that each name means where there is no right one.
TEST(Buffers, AreNamedByDrawBuffer) {
    struct Case {
        GLenum mode;
        Color front, back;
    };
    for (const Case& c :
         {Case{GL_FRONT, red, black}, Case{GL_BACK, black, red}, Case{GL_FRONT_AND_BACK, red, red},
          Case{GL_LEFT, red, red}, Case{GL_FRONT_LEFT, red, black}, Case{GL_BACK_LEFT, black, red},
          Case{GL_NONE, black, black}}) {
        const DoubleBuffered window;
        glDrawBuffer(GL_FRONT_AND_BACK);
        clear_to(black);
        glDrawBuffer(c.mode);
        clear_to(red);
        EXPECT_EQ(pixel_of(window, GL_FRONT), c.front) << c.mode;
        EXPECT_EQ(pixel_of(window, GL_BACK), c.back) << c.mode;
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << c.mode;
    }
}

TEST(Buffers, AreRefusedThatADrawableDoesNotHave) {
    const auto error_of = [](Buffers buffers, GLenum mode) {
        const Window window(8, 8, opengl(), buffers);
        glDrawBuffer(mode);
        const GLenum draw = glGetError();
        glReadBuffer(mode);
        EXPECT_EQ(glGetError(), draw) << mode;
        return draw;
    };
    for (const GLenum mode : {GL_RIGHT, GL_FRONT_RIGHT, GL_BACK_RIGHT, GL_AUX0})
        EXPECT_EQ(error_of(Buffers::Double, mode), GLenum(GL_INVALID_OPERATION)) << mode;
    EXPECT_EQ(error_of(Buffers::Single, GL_BACK_RIGHT), GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(error_of(Buffers::Single, GL_LEFT), GLenum(GL_NO_ERROR));
}

/// As with Mesa, whose OSMesa had no other buffer.
TEST(Buffers, TheBackBufferOfASingleBufferedDrawableIsItsFrontBuffer) {
    for (const GLenum mode : {GL_BACK, GL_BACK_LEFT, GL_FRONT_AND_BACK}) {
        const Window window(8, 8);
        glDrawBuffer(mode);
        clear_to(red);
        for (const GLenum read : {GL_FRONT, GL_BACK, GL_BACK_LEFT})
            EXPECT_EQ(pixel_of(window, read), red) << mode;
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << mode;
        GLint now = 0;
        glGetIntegerv(GL_DRAW_BUFFER, &now);
        EXPECT_EQ(now, GLint(mode));
    }
}

TEST(Buffers, AreCopiedOrExchangedBySwap) {
    for (const SwapMethod method : {SwapMethod::Copy, SwapMethod::Exchange}) {
        DoubleBuffered window;
        window.drawable.set_swap_method(method);
        glDrawBuffer(GL_FRONT);
        clear_to(red);
        glDrawBuffer(GL_BACK);
        clear_to(green);
        window.drawable.swap();
        EXPECT_EQ(pixel_of(window, GL_FRONT), green);
        EXPECT_EQ(pixel_of(window, GL_BACK), method == SwapMethod::Copy ? green : red);
    }
}

/// Programs that draw only what changed grew up on it.
TEST(Buffers, KeepWhatAProgramDoesNotDrawAgain) {
    DoubleBuffered window;
    use_pixel_coordinates(window);
    clear_to(green);
    for (int frame = 0; frame < 5; ++frame) {
        glColor3ub(255, 0, 0);
        glRecti(frame, 0, frame + 1, 1);
        finish_frame(window.context);
        window.drawable.swap();
        for (const GLenum buffer : {GL_FRONT, GL_BACK}) {
            glReadBuffer(buffer);
            for (int x = 0; x < 6; ++x)
                EXPECT_EQ(window.pixel(x, 0), x <= frame ? red : green) << frame << ", " << x;
        }
    }
}

/// Whatever a frame begins with: only a clear of all of it needs no copy.
TEST(Buffers, AreUpToDateForEveryFirstCallOfAFrame) {
    const auto pictures = [](auto first) {
        DoubleBuffered window;
        use_pixel_coordinates(window);
        clear_to(green);
        window.drawable.swap();
        first(window);
        glDisable(GL_SCISSOR_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        return pixel_of(window, GL_BACK);
    };
    EXPECT_EQ(pictures([](DoubleBuffered&) { glClear(GL_DEPTH_BUFFER_BIT); }), green);
    EXPECT_EQ(pictures([](DoubleBuffered&) {
                  glEnable(GL_SCISSOR_TEST);
                  glScissor(0, 0, 1, 1);
                  glClear(GL_COLOR_BUFFER_BIT);
                  glDisable(GL_SCISSOR_TEST);
              }),
              green);
    EXPECT_EQ(pictures([](DoubleBuffered&) {
                  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
                  clear_to(red);
              }),
              green);
    EXPECT_EQ(pictures([](DoubleBuffered&) { clear_to(red); }), red);
    EXPECT_EQ(pictures([](DoubleBuffered& window) { window.drawable.swap(); }), green);
}

/// A machine with one colour plane shows a double-buffered program all the same.
TEST(Buffers, AreOnePlaneOnAMachineThatHasNoOther) {
    DoubleBuffered window(vgx());
    clear_to(green);
    window.drawable.swap();
    EXPECT_EQ(pixel_of(window, GL_FRONT), green);
}

TEST(Buffers, CopyFromTheReadBufferToTheDrawBuffer) {
    const DoubleBuffered window;
    use_pixel_coordinates(window);
    glDrawBuffer(GL_FRONT);
    clear_to(red);
    glDrawBuffer(GL_BACK);
    clear_to(green);
    glReadBuffer(GL_FRONT);
    glRasterPos2i(3, 3);
    glCopyPixels(0, 0, 1, 1, GL_COLOR);
    glReadBuffer(GL_BACK);
    EXPECT_EQ(window.pixel(3, 3), red);
    EXPECT_EQ(window.pixel(4, 3), green);
}

/// [GL11] 4.2.4: ((1/4 + 1/4) + 1/8) / 2 of 255.
TEST(Accum, ComputesWithColours) {
    const Window window(8, 8);
    glClearAccum(0, 0, 0, 0);
    glClear(GL_ACCUM_BUFFER_BIT);
    clear_to({255, 255, 255, 255});
    glAccum(GL_LOAD, 0.25f);
    glAccum(GL_ACCUM, 0.25f);
    glAccum(GL_ADD, 0.125f);
    glAccum(GL_MULT, 0.5f);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(window.pixel(3, 3)[0], 80);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// The mean of equal pictures is the picture, for all its levels.
TEST(Accum, KeepsFractionsOfColours) {
    const Window window(256, 1);
    std::vector<std::array<GLubyte, 4>> levels;
    for (int v = 0; v < 256; ++v)
        levels.push_back({GLubyte(v), GLubyte(255 - v), GLubyte(v / 2), 255});
    glRasterPos2i(-1, -1);
    glDrawPixels(256, 1, GL_RGBA, GL_UNSIGNED_BYTE, levels.data());
    for (int pictures = 1; pictures <= 128; ++pictures) {
        glClear(GL_ACCUM_BUFFER_BIT);
        for (int i = 0; i < pictures; ++i) glAccum(GL_ACCUM, 1 / GLfloat(pictures));
        glAccum(GL_RETURN, 1);
        EXPECT_EQ(window.pixels(), levels) << pictures;
    }
    glAccum(GL_LOAD, 1);
    for (int i = 0; i < 7; ++i) glAccum(GL_MULT, 0.5f);
    for (int i = 0; i < 100; ++i) glAccum(GL_ADD, 0.001f);
    glAccum(GL_RETURN, 2);
    for (int v = 0; v < 256; ++v) EXPECT_NEAR(window.pixel(v, 0)[0], v / 64.0 + 51, 0.52) << v;
}

TEST(Accum, IsClearedToItsValue) {
    const Window window(8, 8);
    glClearAccum(1, 0, 0.6f, -1);
    glClear(GL_ACCUM_BUFFER_BIT);
    glAccum(GL_RETURN, 1);
    EXPECT_EQ(window.pixel(3, 3), (Color{255, 0, 153, 0}));
}

TEST(Clear, ObeysScissorAndMasks) {
    const Window window(8, 8);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 4, 8);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    clear_to({255, 255, 255, 255});
    EXPECT_EQ(window.pixel(3, 3), (Color{255, 0, 255, 255}));
    EXPECT_EQ(window.pixel(4, 3), black);
}

}  // namespace
}  // namespace gw::gl
