// Contexts: sharing, copies, versions, errors, and the functions by name.
#include "tests/gl/x11/client.h"

#include <array>
#include <cstring>
#include <string>
#include <utility>

namespace {

constexpr int bad_context = 0, bad_context_state = 1, bad_fb_config = 9, bad_profile = 13;

class GlxContexts : public Glx {
protected:
    GLXContext make_context(GLXContext share_list = nullptr) const {
        return glXCreateNewContext(display, config(true), GLX_RGBA_TYPE, share_list, True);
    }
    GLXContext with_attributes(std::vector<int> list) const {
        list.push_back(0);
        return glXCreateContextAttribsARB(display, config(true), nullptr, True, list.data());
    }
};

TEST_F(GlxContexts, ShareListsAndTexturesIfAsked) {
    window = make_window(config(true));
    const GLXContext first = make_context(), sharing = make_context(first), alone = make_context();
    ASSERT_TRUE(glXMakeCurrent(display, window, first));
    glNewList(7, GL_COMPILE);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEndList();
    glBindTexture(GL_TEXTURE_2D, 5);
    ASSERT_TRUE(glXMakeCurrent(display, window, sharing));
    EXPECT_TRUE(glIsList(7));
    EXPECT_TRUE(glIsTexture(5));
    glCallList(7);
    glXSwapBuffers(display, window);
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, true, false)));
    ASSERT_TRUE(glXMakeCurrent(display, window, alone));
    EXPECT_FALSE(glIsList(7));
    EXPECT_FALSE(glIsTexture(5));
    // Shared names live as long as one of the contexts.
    glXDestroyContext(display, first);
    ASSERT_TRUE(glXMakeCurrent(display, window, sharing));
    EXPECT_TRUE(glIsList(7));
    glXDestroyContext(display, sharing);
    glXDestroyContext(display, alone);
}

TEST_F(GlxContexts, OfOneWindowDrawInTurn) {
    window = make_window(config(true));
    const GLXContext first = make_context(), second = make_context();
    ASSERT_TRUE(glXMakeCurrent(display, window, first));
    clear_to(1, 0, 0);
    ASSERT_TRUE(glXMakeCurrent(display, window, second));
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 32, 48);
    clear_to(0, 0, 1);
    glXSwapBuffers(display, window);
    const Shown image = shown(window, 64, 48);
    EXPECT_EQ(image.at(31, 5), pixel(false, false, true));
    EXPECT_EQ(image.at(32, 5), pixel(true, false, false));
    glXDestroyContext(display, first);
    glXDestroyContext(display, second);
}

TEST_F(GlxContexts, ADestroyedOneLivesUntilItIsLeft) {
    const GLXContext context = make_current(true);
    glXDestroyContext(display, context);
    EXPECT_EQ(glXGetCurrentContext(), context);
    clear_to(1, 1, 0);
    glXSwapBuffers(display, window);
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, true, false)));
    glXDestroyContext(display, context);
    EXPECT_TRUE(glXMakeCurrent(display, window, context));
    EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr));
    EXPECT_EQ(glXGetCurrentContext(), nullptr);
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(glXMakeCurrent(display, window, context)); }),
              std::vector{glx_error(bad_context)});
    EXPECT_EQ(errors_of([&] { glXDestroyContext(display, context); }),
              std::vector{glx_error(bad_context)});
}

TEST_F(GlxContexts, WithoutAContextNothingHappens) {
    EXPECT_EQ(glXGetCurrentContext(), nullptr);
    EXPECT_EQ(glXGetCurrentDisplay(), nullptr);
    EXPECT_EQ(glXGetCurrentDrawable(), 0u);
    EXPECT_EQ(glGetString(GL_VERSION), nullptr);
    clear_to(1, 0, 0);
    glXWaitGL();
    glXWaitX();
}

TEST_F(GlxContexts, ADrawableAndNoContextDoNotMatch) {
    window = make_window(config(true));
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(glXMakeCurrent(display, window, nullptr)); }),
              std::vector<int>{BadMatch});
    const GLXContext context = make_context();
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(glXMakeCurrent(display, 0, context)); }),
              std::vector<int>{BadMatch});
    glXDestroyContext(display, context);
}

TEST_F(GlxContexts, FeedbackKeepsAContextCurrent) {
    const GLXContext context = make_current(true);
    float buffer[16];
    glFeedbackBuffer(16, GL_2D, buffer);
    glRenderMode(GL_FEEDBACK);
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(glXMakeCurrent(display, 0, nullptr)); }),
              std::vector{glx_error(bad_context_state)});
    glRenderMode(GL_RENDER);
    EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr));
    glXDestroyContext(display, context);
}

TEST_F(GlxContexts, CopyTakesTheGroupsOfTheMask) {
    const GLXContext from = make_current(true), to = make_context();
    glEnable(GL_FOG);
    glLineWidth(3);
    glDepthFunc(GL_GREATER);
    glXCopyContext(display, from, to, GL_LINE_BIT | GL_ENABLE_BIT);
    EXPECT_EQ(errors_of([&] { glXCopyContext(display, to, from, GL_ALL_ATTRIB_BITS); }),
              std::vector<int>{BadAccess});
    ASSERT_TRUE(glXMakeCurrent(display, window, to));
    float width = 0;
    int func = 0;
    glGetFloatv(GL_LINE_WIDTH, &width);
    glGetIntegerv(GL_DEPTH_FUNC, &func);
    EXPECT_EQ(width, 3.0f);
    EXPECT_TRUE(glIsEnabled(GL_FOG));
    EXPECT_EQ(func, GL_LESS);
    glXDestroyContext(display, from);
    glXDestroyContext(display, to);
}

TEST_F(GlxContexts, BuffersAreThoseOfTheConfiguration) {
    for (const bool double_buffered : {false, true}) {
        const GLXContext context = make_current(double_buffered);
        int draw = 0, read = 0, has_back = 0;
        glGetIntegerv(GL_DRAW_BUFFER, &draw);
        glGetIntegerv(GL_READ_BUFFER, &read);
        glGetIntegerv(GL_DOUBLEBUFFER, &has_back);
        EXPECT_EQ(draw, double_buffered ? GL_BACK : GL_FRONT);
        EXPECT_EQ(read, draw);
        EXPECT_EQ(has_back, int(double_buffered));
        glXDestroyContext(display, context);
    }
}

TEST_F(GlxContexts, VersionsUpTo15AreMade) {
    for (const int minor : {0, 1, 2, 3, 4, 5}) {
        const GLXContext context = with_attributes(
            {GLX_CONTEXT_MAJOR_VERSION_ARB, 1, GLX_CONTEXT_MINOR_VERSION_ARB, minor});
        EXPECT_NE(context, nullptr);
        glXDestroyContext(display, context);
    }
    const auto errors = [&](std::vector<int> list) {
        return errors_of([&] { EXPECT_EQ(with_attributes(list), nullptr); });
    };
    EXPECT_EQ(errors({GLX_CONTEXT_MAJOR_VERSION_ARB, 3}), std::vector{glx_error(bad_fb_config)});
    EXPECT_EQ(errors({GLX_CONTEXT_MAJOR_VERSION_ARB, 2}), std::vector{glx_error(bad_fb_config)});
    EXPECT_EQ(errors({GLX_CONTEXT_MINOR_VERSION_ARB, 6}), std::vector<int>{BadMatch});
    EXPECT_EQ(errors({GLX_CONTEXT_FLAGS_ARB, 2}), std::vector<int>{BadMatch});
    EXPECT_EQ(errors({GLX_RENDER_TYPE, GLX_COLOR_INDEX_TYPE}), std::vector<int>{BadMatch});
    EXPECT_EQ(errors({GLX_RENDER_TYPE, 0x7777}), std::vector<int>{BadValue});
    EXPECT_EQ(errors({0x7777, 3}), std::vector<int>{BadValue});
    EXPECT_EQ(errors({GLX_CONTEXT_PROFILE_MASK_ARB, 3}), std::vector{glx_error(bad_profile)});
    EXPECT_EQ(errors_of([&] { glXCreateNewContext(display, nullptr, GLX_RGBA_TYPE, nullptr, 1); }),
              std::vector{glx_error(bad_fb_config)});
}

/// GLX_MESA_query_renderer
TEST_F(GlxContexts, TheRendererIsSoftwareOfVersion1_5) {
    std::array<unsigned, 3> values{9, 9, 9};
    const auto query = [&](int attribute) {
        return glXQueryRendererIntegerMESA(display, DefaultScreen(display), 0, attribute,
                                           values.data());
    };
    ASSERT_TRUE(query(GLX_RENDERER_ACCELERATED_MESA));
    EXPECT_EQ(values[0], unsigned(False));
    ASSERT_TRUE(query(GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA));
    EXPECT_EQ(values, (std::array{1u, 5u, 9u}));
    ASSERT_TRUE(query(GLX_RENDERER_OPENGL_CORE_PROFILE_VERSION_MESA));
    EXPECT_EQ(values, (std::array{0u, 0u, 9u}));
    ASSERT_TRUE(query(GLX_RENDERER_VIDEO_MEMORY_MESA));
    EXPECT_GT(values[0], 0u);
    EXPECT_FALSE(query(0x7777));
    EXPECT_FALSE(
        glXQueryRendererIntegerMESA(display, 0, 1, GLX_RENDERER_ACCELERATED_MESA, values.data()));
    EXPECT_STREQ(glXQueryRendererStringMESA(display, 0, 0, GLX_RENDERER_VENDOR_ID_MESA), "GW");
    EXPECT_EQ(glXQueryCurrentRendererStringMESA(GLX_RENDERER_VENDOR_ID_MESA), nullptr);
    const GLXContext context = make_current(true);
    EXPECT_STREQ(glXQueryCurrentRendererStringMESA(GLX_RENDERER_DEVICE_ID_MESA),
                 reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    EXPECT_TRUE(glXQueryCurrentRendererIntegerMESA(GLX_RENDERER_VERSION_MESA, values.data()));
    glXDestroyContext(display, context);
}

/// What Xlib's default handler of errors prints.
TEST_F(GlxContexts, ErrorsHaveTheirNames) {
    const auto text_of = [&](int code) {
        char text[64] = {};
        XGetErrorText(display, code, text, int(sizeof text));
        return std::string(text);
    };
    EXPECT_EQ(text_of(glx_error(0)), "GLXBadContext");
    EXPECT_EQ(text_of(glx_error(2)), "GLXBadDrawable");
    EXPECT_EQ(text_of(glx_error(9)), "GLXBadFBConfig");
    EXPECT_EQ(text_of(glx_error(13)), "GLXBadProfileARB");
    EXPECT_EQ(text_of(glx_error(14)).substr(0, 3), std::to_string(glx_error(14)).substr(0, 3));
    EXPECT_EQ(text_of(BadMatch).substr(0, 8), "BadMatch");
}

TEST_F(GlxContexts, FunctionsAreFoundByName) {
    const auto find = [](const char* name) {
        return glXGetProcAddress(reinterpret_cast<const GLubyte*>(name));
    };
    EXPECT_EQ(find("glXSwapBuffers"), reinterpret_cast<__GLXextFuncPtr>(&glXSwapBuffers));
    EXPECT_EQ(find("glXGetProcAddressARB"),
              reinterpret_cast<__GLXextFuncPtr>(&glXGetProcAddressARB));
    EXPECT_EQ(find("glBegin"), reinterpret_cast<__GLXextFuncPtr>(&glBegin));
    EXPECT_EQ(find("glXNoSuchFunction"), nullptr);
    EXPECT_EQ(find("glXSwapIntervalSGI"), nullptr) << "no swap waits";
    EXPECT_EQ(find("glNoSuchFunction"), nullptr);
}

TEST_F(GlxContexts, ClosingTheDisplayWhileCurrentIsAllowed) {
    Display* const kept = std::exchange(display, XOpenDisplay(nullptr));
    make_current(true);
    XCloseDisplay(std::exchange(display, kept));
    clear_to(1, 0, 0);
    glFlush();
    float read[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, read);
    EXPECT_EQ(read[0], 1.0f);
}

/// The pixels that a list of glyphs sets are those of XDrawString.
/// One row higher, as the manual page of UseXFont has it.
TEST_F(GlxContexts, UseXFontDrawsWhatXDraws) {
    const Font font = XLoadFont(display, "fixed");
    const GLXContext context = make_current(true, 64, 48);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    glXUseXFont(font, 32, 96, 1032);
    int alignment = 0;
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
    EXPECT_EQ(alignment, 8);

    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 64, 0, 48, -1, 1);
    clear_to(0, 0, 0);
    glColor3f(1, 1, 1);
    glRasterPos2i(4, 20);
    glListBase(1000);
    const char text[] = "Ag_j1";
    glCallLists(int(std::strlen(text)), GL_UNSIGNED_BYTE, text);
    glXSwapBuffers(display, window);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));

    const Pixmap pixmap = XCreatePixmap(display, window, 64, 48,
                                        unsigned(DefaultDepth(display, DefaultScreen(display))));
    const GC gc = XCreateGC(display, pixmap, 0, nullptr);
    XSetForeground(display, gc, 0);
    XFillRectangle(display, pixmap, gc, 0, 0, 64, 48);
    XSetForeground(display, gc, pixel(true, true, true));
    XSetFont(display, gc, font);
    XDrawString(display, pixmap, gc, 4, 48 - 20 - 1, text, int(std::strlen(text)));
    EXPECT_EQ(shown(window, 64, 48).pixels, shown(pixmap, 64, 48).pixels);
    EXPECT_FALSE(shown(window, 64, 48).is_all(0));
    XFreeGC(display, gc);
    glXDestroyContext(display, context);
}

}  // namespace
