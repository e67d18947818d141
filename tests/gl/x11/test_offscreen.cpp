// Pixmaps, pbuffers, and drawing from several threads.
#include "tests/gl/x11/client.h"

#include <array>
#include <atomic>
#include <set>
#include <thread>

namespace {

class GlxOffscreen : public Glx {
protected:
    GLXPbuffer make_pbuffer(Display* on, GLXFBConfig with, int width, int height) const {
        const int list[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, 0};
        return glXCreatePbuffer(on, with, list);
    }
};

std::array<float, 4> read_pixel(int x, int y) {
    std::array<float, 4> out{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_FLOAT, out.data());
    return out;
}

TEST_F(GlxOffscreen, APixmapHasThePicture) {
    const GLXFBConfig with = config(false);
    const Pixmap pixmap =
        XCreatePixmap(display, RootWindow(display, DefaultScreen(display)), 30, 20,
                      unsigned(DefaultDepth(display, DefaultScreen(display))));
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    const GLXPixmap name = glXCreatePixmap(display, with, pixmap, nullptr);
    ASSERT_TRUE(glXMakeCurrent(display, name, context));
    clear_to(1, 1, 0);
    glFinish();
    EXPECT_TRUE(shown(pixmap, 30, 20).is_all(pixel(true, true, false)));
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyPixmap(display, name);
    EXPECT_EQ(errors_of([&] { glXDestroyPixmap(display, name); }), std::vector{glx_error(3)});
    EXPECT_EQ(errors_of([&] { glXCreatePixmap(display, with, 0x7FFFFF, nullptr); }),
              std::vector<int>{BadPixmap});
    glXDestroyContext(display, context);
}

/// X prints the request's name by its number.
TEST_F(GlxOffscreen, ErrorsNameTheRequestThatWasMade) {
    static int request = 0;
    const XErrorHandler before = XSetErrorHandler([](Display*, XErrorEvent* error) {
        request = error->minor_code;
        return 0;
    });
    glXDestroyPixmap(display, 0x7FFFFF);
    EXPECT_EQ(request, 23);  // X_GLXDestroyPixmap
    glXDestroyGLXPixmap(display, 0x7FFFFF);
    EXPECT_EQ(request, 15);  // X_GLXDestroyGLXPixmap
    XSetErrorHandler(before);
}

TEST_F(GlxOffscreen, APixmapThatWasLeftIsNotWrittenAgain) {
    const GLXFBConfig with = config(false);
    const Pixmap pixmap = make_pixmap(30, 20);
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    const GLXPixmap name = glXCreatePixmap(display, with, pixmap, nullptr);
    ASSERT_TRUE(glXMakeCurrent(display, name, context));
    clear_to(1, 1, 0);
    glXMakeCurrent(display, 0, nullptr);
    EXPECT_TRUE(shown(pixmap, 30, 20).is_all(pixel(true, true, false)));
    fill(pixmap, pixel(false, false, true), 30, 20);
    glXDestroyContext(display, context);
    EXPECT_TRUE(shown(pixmap, 30, 20).is_all(pixel(false, false, true)));
    glXDestroyPixmap(display, name);
    EXPECT_TRUE(shown(pixmap, 30, 20).is_all(pixel(false, false, true)));
}

TEST_F(GlxOffscreen, APixmapFreedWhileCurrentRaisesNoError) {
    const GLXFBConfig with = config(false);
    const Pixmap pixmap = make_pixmap(30, 20);
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    const GLXPixmap name = glXCreatePixmap(display, with, pixmap, nullptr);
    ASSERT_TRUE(glXMakeCurrent(display, name, context));
    clear_to(1, 1, 0);
    glFinish();
    EXPECT_EQ(errors_of([&] {
                  glXDestroyPixmap(display, name);
                  XFreePixmap(display, pixmap);
                  clear_to(1, 0, 0);
                  glFinish();
                  glXMakeCurrent(display, 0, nullptr);
                  glXDestroyContext(display, context);
              }),
              std::vector<int>());
}

TEST_F(GlxOffscreen, AWindowIsNoPixmap) {
    const GLXFBConfig with = config(true);
    window = make_window(with);
    EXPECT_EQ(errors_of([&] { glXCreatePixmap(display, with, window, nullptr); }),
              std::vector<int>{BadPixmap});
    const Pixmap pixmap =
        XCreatePixmap(display, window, 30, 20, unsigned(DefaultDepth(display, 0)));
    EXPECT_EQ(errors_of([&] { glXCreateWindow(display, with, pixmap, nullptr); }),
              std::vector<int>{BadWindow});
}

TEST_F(GlxOffscreen, APbufferIsQueried) {
    const GLXPbuffer pbuffer = make_pbuffer(display, config(true), 33, 22);
    const auto value = [&](int name) {
        unsigned out = 0x7777;
        glXQueryDrawable(display, pbuffer, name, &out);
        return out;
    };
    EXPECT_EQ(value(GLX_WIDTH), 33u);
    EXPECT_EQ(value(GLX_HEIGHT), 22u);
    EXPECT_EQ(value(GLX_PRESERVED_CONTENTS), 1u);
    EXPECT_EQ(value(GLX_LARGEST_PBUFFER), 0u);
    int id = 0;
    glXGetFBConfigAttrib(display, config(true), GLX_FBCONFIG_ID, &id);
    EXPECT_EQ(value(GLX_FBCONFIG_ID), unsigned(id));
    unsigned long mask = 0;
    glXSelectEvent(display, pbuffer, GLX_PBUFFER_CLOBBER_MASK);
    glXGetSelectedEvent(display, pbuffer, &mask);
    EXPECT_EQ(mask, (unsigned long)GLX_PBUFFER_CLOBBER_MASK);
    glXDestroyPbuffer(display, pbuffer);
    EXPECT_EQ(errors_of([&] { value(GLX_WIDTH); }), std::vector{glx_error(2)});
    EXPECT_EQ(errors_of([&] { EXPECT_EQ(make_pbuffer(display, config(true), 99999, 9), 0u); }),
              std::vector<int>{BadAlloc});
}

/// [GLX 1.4] 2.1 compares the bits of OpenGL's buffers, which all visuals have here. Qt draws to
/// pbuffers whose visual has another depth than its context's.
TEST_F(GlxOffscreen, PbuffersOfAllVisualsMatchAContext) {
    const GLXContext context =
        glXCreateNewContext(display, config(true), GLX_RGBA_TYPE, nullptr, True);
    int count = 0;
    GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
    for (int i = 0; i < count; ++i) {
        const GLXPbuffer pbuffer = make_pbuffer(display, all[i], 8, 8);
        EXPECT_TRUE(glXMakeContextCurrent(display, pbuffer, pbuffer, context)) << i;
        clear_to(0, 1, 0);
        EXPECT_EQ(read_pixel(7, 7), (std::array{0.0f, 1.0f, 0.0f, 1.0f})) << i;
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyPbuffer(display, pbuffer);
    }
    XFree(all);
    glXDestroyContext(display, context);
}

TEST_F(GlxOffscreen, OneDrawableIsDrawnToAndAnotherRead) {
    const GLXFBConfig with = config(true);
    const GLXPbuffer draw = make_pbuffer(display, with, 8, 8);
    const GLXPbuffer read = make_pbuffer(display, with, 16, 16);
    const GLXContext context = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    ASSERT_TRUE(glXMakeContextCurrent(display, read, read, context));
    clear_to(0, 1, 0);
    ASSERT_TRUE(glXMakeContextCurrent(display, draw, read, context));
    EXPECT_EQ(glXGetCurrentDrawable(), draw);
    EXPECT_EQ(glXGetCurrentReadDrawable(), read);
    clear_to(1, 0, 0);
    EXPECT_EQ(read_pixel(15, 15), (std::array{0.0f, 1.0f, 0.0f, 1.0f}));
    ASSERT_TRUE(glXMakeContextCurrent(display, draw, draw, context));
    EXPECT_EQ(read_pixel(7, 7), (std::array{1.0f, 0.0f, 0.0f, 1.0f}));
    // A drawable that was destroyed while it is current can be drawn to until it is left.
    glXDestroyPbuffer(display, draw);
    clear_to(0, 0, 1);
    EXPECT_EQ(read_pixel(7, 7), (std::array{0.0f, 0.0f, 1.0f, 1.0f}));
    glXDestroyContext(display, context);
}

TEST_F(GlxOffscreen, AContextBelongsToOneThread) {
    const GLXContext context = make_current(true);
    EXPECT_EQ(errors_of([&] {
                  std::thread([&] {
                      EXPECT_FALSE(glXMakeCurrent(display, window, context));
                      EXPECT_EQ(glXGetCurrentContext(), nullptr);
                  }).join();
              }),
              std::vector<int>{BadAccess});
    glXMakeCurrent(display, 0, nullptr);
    std::thread([&] { EXPECT_TRUE(glXMakeCurrent(display, window, context)); }).join();
    // The thread has ended, so the context is free.
    EXPECT_TRUE(glXMakeCurrent(display, window, context));
    glXDestroyContext(display, context);
}

/// Names come from Xlib, which has one ready at a time for all threads.
TEST_F(GlxOffscreen, ThreadsGetNamesOfTheirOwn) {
    constexpr int threads = 8, names = 500;
    const GLXFBConfig with = config(true);
    std::array<std::vector<XID>, threads> of_thread;
    {
        std::vector<std::jthread> running;
        for (std::vector<XID>& got : of_thread)
            running.emplace_back([&] {
                for (int n = 0; n < names; ++n) {
                    const GLXContext context =
                        glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
                    got.push_back(make_pbuffer(display, with, 1, 1));
                    glXDestroyContext(display, context);
                }
            });
    }
    std::set<XID> all;
    for (const std::vector<XID>& got : of_thread) all.insert(got.begin(), got.end());
    EXPECT_EQ(all.size(), std::size_t(threads * names));
    for (const XID name : all) glXDestroyPbuffer(display, name);
}

/// Each thread draws with its own context, all at the same time, on one display.
TEST_F(GlxOffscreen, ThreadsDrawToDrawablesOfTheirOwn) {
    const GLXFBConfig with = config(true);
    const GLXContext first = glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            const GLXPbuffer pbuffer = make_pbuffer(display, with, 16 + t, 16);
            const GLXContext context =
                glXCreateNewContext(display, with, GLX_RGBA_TYPE, first, True);
            for (int round = 0; round < 20; ++round) {
                ASSERT_TRUE(glXMakeCurrent(display, pbuffer, context));
                const GLuint list = glGenLists(1);
                const float color = float((t * 20 + round) % 2);
                glNewList(list, GL_COMPILE);
                clear_to(color, 1 - color, float(t % 2));
                glEndList();
                glCallList(list);
                EXPECT_EQ(read_pixel(15 + t, 15),
                          (std::array{color, 1 - color, float(t % 2), 1.0f}));
                glDeleteLists(list, 1);
                ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
            }
            glXDestroyContext(display, context);
            glXDestroyPbuffer(display, pbuffer);
        });
    for (std::thread& thread : threads) thread.join();
    glXDestroyContext(display, first);
}

/// Two threads draw halves of one window; each half has its thread's colour only.
TEST_F(GlxOffscreen, ThreadsDrawToOneWindow) {
    const GLXFBConfig with = config(true);
    window = make_window(with, 64, 48);
    std::vector<std::thread> threads;
    for (int t = 0; t < 2; ++t)
        threads.emplace_back([&, t] {
            const GLXContext context =
                glXCreateNewContext(display, with, GLX_RGBA_TYPE, nullptr, True);
            ASSERT_TRUE(glXMakeCurrent(display, window, context));
            glEnable(GL_SCISSOR_TEST);
            glScissor(32 * t, 0, 32, 48);
            for (int round = 0; round < 50; ++round) {
                clear_to(float(t), 1, 0);
                if (round % 10 == 0) glXSwapBuffers(display, window);
            }
            ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
            glXDestroyContext(display, context);
        });
    for (std::thread& thread : threads) thread.join();
    glXSwapBuffers(display, window);
    const Shown image = shown(window, 64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_EQ(image.at(x, y), pixel(x >= 32, true, false));
}

}  // namespace
