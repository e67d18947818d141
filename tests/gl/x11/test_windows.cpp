// Windows: what is shown when, sizes, and windows that vanish.
#include "tests/gl/x11/client.h"

namespace {

class GlxWindow : public Glx {};

TEST_F(GlxWindow, ADoubleBufferedOneShowsAtSwap) {
    const GLXContext context = make_current(true);
    clear_to(1, 0, 0);
    glFinish();
    EXPECT_FALSE(shown(window, 64, 48).is_all(pixel(true, false, false)));
    glXSwapBuffers(display, window);
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, false, false)));
    glXDestroyContext(display, context);
}

/// GLX_ARB_multisample: a column half of whose samples are covered, also where frames are executed
/// while the program goes on.
TEST_F(GlxWindow, SamplesAreShownAsTheirMeans) {
    for (const int double_buffered : {False, True}) {
        const int list[] = {GLX_DOUBLEBUFFER, double_buffered, GLX_SAMPLES, 4, 0};
        int count = 0;
        GLXFBConfig* const found = glXChooseFBConfig(display, DefaultScreen(display), list, &count);
        ASSERT_GT(count, 0);
        window = make_window(found[0]);
        const GLXContext context =
            glXCreateNewContext(display, found[0], GLX_RGBA_TYPE, nullptr, True);
        ASSERT_TRUE(glXMakeCurrent(display, window, context));
        glOrtho(0, 64, 0, 48, -1, 1);
        for (int frame = 0; frame < 40; ++frame) {
            clear_to(0, 0, 0);
            glRectf(10.5f, 0, 64, 48);
            double_buffered ? glXSwapBuffers(display, window) : glFlush();
        }
        glFinish();
        const Shown image = shown(window, 64, 48);
        const unsigned long mask = DefaultVisual(display, DefaultScreen(display))->green_mask,
                            largest = mask / (mask & (~mask + 1));
        for (int y = 0; y < 48; ++y) {
            EXPECT_EQ(image.at(9, y), pixel(false, false, false)) << y;
            EXPECT_EQ((image.at(10, y) & mask) * largest / mask, (128 * largest + 127) / 255) << y;
            EXPECT_EQ(image.at(11, y), pixel(true, true, true)) << y;
        }
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyContext(display, context);
        XFree(found);
    }
}

TEST_F(GlxWindow, TheFrontBufferIsShownAtFlush) {
    const GLXContext context = make_current(true);
    clear_to(1, 0, 0);
    glDrawBuffer(GL_FRONT);
    clear_to(0, 1, 0);
    glFlush();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, true, false)));
    glXSwapBuffers(display, window);
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, false, false)));
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, ASingleBufferedOneShowsAtFlush) {
    const GLXContext context = make_current(false);
    clear_to(0, 1, 0);
    glFlush();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, true, false)));
    clear_to(0, 0, 1);
    glXWaitGL();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, false, true)));
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, RowZeroIsTheLowest) {
    const GLXContext context = make_current(true);
    clear_to(0, 0, 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 5, 3);
    clear_to(1, 1, 1);
    glXSwapBuffers(display, window);
    const Shown image = shown(window, 64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool inside = x < 5 && y >= 45;
            EXPECT_EQ(image.at(x, y), pixel(inside, inside, inside)) << x << ' ' << y;
        }
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, ChannelsAreRoundedToTheVisuals) {
    const GLXContext context = make_current(true, 256, 4);
    for (int i = 0; i < 256; ++i) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(i, 0, 1, 4);
        clear_to(float(i) / 255, float(i) / 255, float(i) / 255);
    }
    glXSwapBuffers(display, window);
    const Shown image = shown(window, 256, 4);
    const Visual* const visual = DefaultVisual(display, DefaultScreen(display));
    for (const unsigned long mask : {visual->red_mask, visual->green_mask, visual->blue_mask}) {
        const unsigned long unit = mask & (~mask + 1), largest = mask / unit;
        for (int i = 0; i < 256; ++i)
            EXPECT_EQ((image.at(i, 0) & mask) / unit, (unsigned(i) * largest + 127) / 255) << i;
    }
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, ANewSizeCountsFromTheNextSwap) {
    const GLXContext context = make_current(true, 64, 48);
    int viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 64);
    EXPECT_EQ(viewport[3], 48);
    XResizeWindow(display, window, 100, 80);
    XSync(display, False);
    glXSwapBuffers(display, window);
    clear_to(1, 0, 1);
    glXSwapBuffers(display, window);
    EXPECT_TRUE(shown(window, 100, 80).is_all(pixel(true, false, true)));
    unsigned width = 0, height = 0;
    glXQueryDrawable(display, window, GLX_WIDTH, &width);
    glXQueryDrawable(display, window, GLX_HEIGHT, &height);
    EXPECT_EQ(width, 100u);
    EXPECT_EQ(height, 80u);
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 64);
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, DestroyedWhileCurrentItRaisesNoError) {
    for (const bool double_buffered : {false, true}) {
        const GLXContext context = make_current(double_buffered);
        XDestroyWindow(display, window);
        XSync(display, False);
        EXPECT_EQ(errors_of([&] {
                      clear_to(1, 0, 0);
                      glFlush();
                      glXSwapBuffers(display, window);
                      clear_to(0, 1, 0);
                      glFlush();
                  }),
                  std::vector<int>());
        float read[4] = {};
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, read);
        EXPECT_EQ(read[1], 1.0f);
        EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr));
        glXDestroyContext(display, context);
    }
}

TEST_F(GlxWindow, AnUnknownNameIsAnError) {
    const GLXContext context =
        glXCreateNewContext(display, config(true), GLX_RGBA_TYPE, nullptr, True);
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(glXMakeCurrent(display, 0x7FFFFF, context)); }),
              std::vector{glx_error(2)});  // GLXBadDrawable
    EXPECT_EQ(errors_of([&] { glXSwapBuffers(display, 0x7FFFFF); }), std::vector{glx_error(2)});
    glXDestroyContext(display, context);
}

TEST_F(GlxWindow, AGlxWindowIsItsWindow) {
    const GLXFBConfig with = config(true);
    window = make_window(with);
    const GLXWindow name = glXCreateWindow(display, with, window, nullptr);
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    EXPECT_TRUE(glXMakeContextCurrent(display, name, name, context));
    EXPECT_EQ(glXGetCurrentDrawable(), name);
    clear_to(0, 1, 1);
    glXSwapBuffers(display, name);
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, true, true)));
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyWindow(display, name);
    EXPECT_EQ(errors_of([&] { glXDestroyWindow(display, name); }), std::vector{glx_error(12)});
    // A GLX window goes with its window.
    const GLXWindow second = glXCreateWindow(display, with, window, nullptr);
    EXPECT_EQ(errors_of([&] { EXPECT_EQ(glXCreateWindow(display, with, window, nullptr), 0u); }),
              std::vector<int>{BadAlloc});
    XDestroyWindow(display, window);
    EXPECT_EQ(errors_of([&] { glXDestroyWindow(display, second); }), std::vector{glx_error(12)});
    glXDestroyContext(display, context);
}

}  // namespace
