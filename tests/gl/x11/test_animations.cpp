// Windows that show frame after frame: each is executed by a thread while the program makes the
// next. Nothing else may differ.
#include "tests/gl/x11/client.h"

#include <array>

namespace {

class GlxAnimation : public Glx {
protected:
    /// A colour of frame i, with channels 0 or 1.
    static std::array<bool, 3> color(int i) { return {i % 2 != 0, i / 2 % 2 != 0, i / 4 % 2 != 0}; }
    static void clear_for(int i) {
        const auto [r, g, b] = color(i);
        clear_to(r ? 1 : 0, g ? 1 : 0, b ? 1 : 0);
    }
    unsigned long pixel_of(int i) const {
        const auto [r, g, b] = color(i);
        return pixel(r, g, b);
    }
    /// Frames 0 .. count - 1.
    void animate(int count) {
        for (int i = 0; i < count; ++i) {
            clear_for(i);
            glXSwapBuffers(display, window);
        }
    }
    static constexpr int frames = 60;
};

TEST_F(GlxAnimation, ShowsTheLastFrameWhenWaitedFor) {
    const GLXContext context = make_current(true);
    for (int count = frames; count < frames + 8; ++count) {
        animate(count);
        count % 2 == 0 ? glFinish() : glXWaitGL();
        EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(count - 1))) << count;
    }
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, EveryFrameIsRead) {
    const GLXContext context = make_current(true);
    for (int i = 0; i < frames; ++i) {
        clear_for(i);
        glXSwapBuffers(display, window);
        glReadBuffer(GL_FRONT);
        unsigned char read[4] = {};
        glReadPixels(7, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(read[c], color(i)[c] ? 255 : 0) << i;
    }
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, AFrameHasItsOwnTexels) {
    const GLXContext context = make_current(true);
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    const auto load = [&](int i, bool whole) {
        unsigned char texels[8 * 8 * 3];
        for (std::size_t t = 0; t < sizeof texels; ++t) texels[t] = color(i)[t % 3] ? 255 : 0;
        if (whole)
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
        else
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, texels);
    };
    load(0, true);
    for (int i = 1; i < frames; ++i) {
        load(i, i % 3 == 0);
        glRectf(-1, -1, 1, 1);
        glXSwapBuffers(display, window);
        load(i + 1, false);  // too late for this frame
        if (i % 4 != 3) continue;
        glFinish();
        EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(i))) << i;
    }
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, FlushesBeforeTheSwapChangeNothing) {
    const GLXContext context = make_current(true);
    for (int i = 0; i < frames; ++i) {
        clear_for(i);
        glFlush();
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 64, 24);
        clear_for(i + 1);
        glFinish();
        glDisable(GL_SCISSOR_TEST);
        glXSwapBuffers(display, window);
    }
    glFinish();
    const Shown image = shown(window, 64, 48);
    EXPECT_EQ(image.at(0, 0), pixel_of(frames - 1));
    EXPECT_EQ(image.at(0, 47), pixel_of(frames));
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, TheFrontBufferIsDrawnToInBetween) {
    const GLXContext context = make_current(true);
    animate(frames);
    glDrawBuffer(GL_FRONT);
    clear_to(1, 0, 1);
    glFlush();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, false, true)));
    glDrawBuffer(GL_BACK);
    animate(frames + 1);
    glFinish();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(frames)));
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, FollowsTheWindowsSize) {
    const GLXContext context = make_current(true, 64, 48);
    animate(frames);
    for (int i = 0; i < 10; ++i) {
        const int width = 64 + 7 * i, height = 48 + 5 * i;
        XResizeWindow(display, window, unsigned(width), unsigned(height));
        animate(5);
        glFinish();
        EXPECT_TRUE(shown(window, width, height).is_all(pixel_of(4))) << i;
    }
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, AWindowThatIsDestroyedRaisesNoError) {
    const GLXContext context = make_current(true);
    animate(frames);
    EXPECT_EQ(errors_of([&] {
                  XDestroyWindow(display, window);
                  XSync(display, False);
                  animate(5);
                  glFinish();
              }),
              std::vector<int>());
    EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr));
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, AGrabOfTheServerHoldsNothingUp) {
    const GLXContext context = make_current(true);
    animate(frames);
    XGrabServer(display);
    animate(frames + 1);
    glFinish();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(frames)));
    clear_for(1);
    glXSwapBuffers(display, window);  // shown now, or by us once the server answers
    XUngrabServer(display);
    glXWaitGL();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(1)));
    animate(frames);
    glXWaitGL();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel_of(frames - 1)));
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, AllMayHappenInAGrab) {
    XGrabServer(display);
    for (int round = 0; round < 3; ++round) {
        const GLXContext context = make_current(true);
        animate(frames);
        XResizeWindow(display, window, 70, 50);
        animate(frames);
        glXWaitGL();
        EXPECT_TRUE(shown(window, 70, 50).is_all(pixel_of(frames - 1)));
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyContext(display, context);
        XDestroyWindow(display, window);
    }
    XUngrabServer(display);
}

TEST_F(GlxAnimation, AWindowMayEndInAGrab) {
    const GLXContext context = make_current(true);
    animate(frames);
    XGrabServer(display);
    animate(1);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, context);
    XDestroyWindow(display, window);
    XUngrabServer(display);
}

TEST_F(GlxAnimation, EndsWithItsContextAndWindow) {
    for (int round = 0; round < 5; ++round) {
        const GLXContext context = make_current(true);
        animate(frames);
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyContext(display, context);
        XDestroyWindow(display, window);
    }
}

TEST_F(GlxAnimation, TwoWindowsTakeTurns) {
    const GLXContext context = make_current(true);
    const Window first = window, second = make_window(config(true));
    XMoveWindow(display, second, 100, 0);
    for (int i = 0; i < frames; ++i)
        for (const Window each : {first, second}) {
            glXMakeCurrent(display, each, context);
            clear_for(each == first ? i : i + 1);
            glXSwapBuffers(display, each);
        }
    glXMakeCurrent(display, first, context);
    glXWaitGL();
    EXPECT_TRUE(shown(first, 64, 48).is_all(pixel_of(frames - 1)));
    glXMakeCurrent(display, second, context);
    glXWaitGL();
    EXPECT_TRUE(shown(second, 64, 48).is_all(pixel_of(frames)));
    glXDestroyContext(display, context);
}

TEST_F(GlxAnimation, TheDisplayMayBeClosed) {
    const GLXContext context = make_current(true);
    animate(frames);
    XCloseDisplay(display);
    display = XOpenDisplay(nullptr);
    EXPECT_NE(context, nullptr);
}

}  // namespace
