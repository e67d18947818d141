// EGL in windows and pixmaps of X11: what the server shows. [EGL 1.5]
#include "tests/gl/x11/client.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace {

class EglX11 : public Glx {
protected:
    void SetUp() override {
        Glx::SetUp();
        egl = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, display, nullptr);
        ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
        ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(egl, nullptr, &egl_config, 1, &count));
        ASSERT_EQ(count, 1);
    }
    void TearDown() override {
        eglReleaseThread();
        Glx::TearDown();
    }

    EGLSurface make_surface(Window of, EGLint render_buffer = EGL_BACK_BUFFER) const {
        const EGLint list[] = {EGL_RENDER_BUFFER, render_buffer, EGL_NONE};
        return eglCreateWindowSurface(egl, egl_config, of, list);
    }
    /// A surface of a new window of 64 x 48, current with a new context.
    EGLSurface draw_to_window(EGLint render_buffer = EGL_BACK_BUFFER) {
        window = make_window(config(true));
        const EGLSurface surface = make_surface(window, render_buffer);
        const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
        EXPECT_TRUE(eglMakeCurrent(egl, surface, surface, context));
        return surface;
    }

    EGLDisplay egl = nullptr;
    EGLConfig egl_config = nullptr;
};

TEST_F(EglX11, TheFirstConfigurationHasTheDefaultVisual) {
    EGLint visual = 0, type = 0;
    EXPECT_TRUE(eglGetConfigAttrib(egl, egl_config, EGL_NATIVE_VISUAL_ID, &visual));
    const Visual* const initial = DefaultVisual(display, DefaultScreen(display));
    EXPECT_EQ(VisualID(visual), XVisualIDFromVisual(const_cast<Visual*>(initial)));
    EXPECT_TRUE(eglGetConfigAttrib(egl, egl_config, EGL_SURFACE_TYPE, &type));
    EXPECT_EQ(type, EGL_WINDOW_BIT | EGL_PIXMAP_BIT | EGL_PBUFFER_BIT);
}

/// EGL_SAMPLES: half of the samples of column 2 are covered.
TEST_F(EglX11, SamplesOfAPbufferAreReadAsTheirMeans) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_SAMPLES, 4, EGL_NONE},
                 size[] = {EGL_WIDTH, 8, EGL_HEIGHT, 8, EGL_NONE};
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(egl, wanted, &egl_config, 1, &count));
    ASSERT_EQ(count, 1);
    const EGLSurface surface = eglCreatePbufferSurface(egl, egl_config, size);
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context));
    const auto red_at = [](int x) {
        GLubyte red = 1;
        glReadPixels(x, 1, 1, 1, GL_RED, GL_UNSIGNED_BYTE, &red);
        return int(red);
    };
    glOrtho(0, 8, 0, 8, -1, 1);
    for (int frame = 0; frame < 3; ++frame) {
        clear_to(0, 0, 0);
        glRectf(2.5f, 0, 8, 8);
        EXPECT_EQ(red_at(1), 0);
        EXPECT_EQ(red_at(2), 128);
        EXPECT_EQ(red_at(3), 255);
        EXPECT_TRUE(eglSwapBuffers(egl, surface));
        EXPECT_EQ(red_at(2), 128) << "it stays";
    }
}

TEST_F(EglX11, SwapBuffersShowsTheBackBuffer) {
    const EGLSurface surface = draw_to_window();
    clear_to(1, 0, 0);
    EXPECT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, false, false)));
    clear_to(0, 1, 0);
    glFinish();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(true, false, false)));
}

TEST_F(EglX11, ASingleBufferIsShownAtFlush) {
    draw_to_window(EGL_SINGLE_BUFFER);
    GLboolean is_double = GL_TRUE;
    glGetBooleanv(GL_DOUBLEBUFFER, &is_double);
    EXPECT_FALSE(is_double);
    clear_to(0, 0, 1);
    glFlush();
    EXPECT_TRUE(shown(window, 64, 48).is_all(pixel(false, false, true)));
}

TEST_F(EglX11, ASurfaceFollowsItsWindow) {
    const EGLSurface surface = draw_to_window();
    XResizeWindow(display, window, 80, 20);
    XSync(display, False);
    EXPECT_TRUE(eglSwapBuffers(egl, surface));
    EGLint width = 0;
    EXPECT_TRUE(eglQuerySurface(egl, surface, EGL_WIDTH, &width));
    EXPECT_EQ(width, 80);
    clear_to(1, 1, 0);
    EXPECT_TRUE(eglSwapBuffers(egl, surface));
    EXPECT_TRUE(shown(window, 80, 20).is_all(pixel(true, true, false)));
}

TEST_F(EglX11, WindowsAreChecked) {
    EXPECT_EQ(make_surface(12345), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    const EGLSurface surface = draw_to_window();
    EXPECT_EQ(make_surface(window), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    XDestroyWindow(display, window);
    XSync(display, False);
    EXPECT_FALSE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
}

TEST_F(EglX11, DrawsToAPixmap) {
    const int depth = DefaultDepth(display, DefaultScreen(display));
    const Pixmap pixmap =
        XCreatePixmap(display, DefaultRootWindow(display), 16, 8, unsigned(depth));
    const EGLSurface surface = eglCreatePixmapSurface(egl, egl_config, pixmap, nullptr);
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context));
    clear_to(0, 1, 1);
    EXPECT_TRUE(eglWaitGL());
    EXPECT_TRUE(shown(pixmap, 16, 8).is_all(pixel(false, true, true)));
    const Window root = DefaultRootWindow(display);
    EXPECT_EQ(eglCreatePixmapSurface(egl, egl_config, root, nullptr), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
}

TEST_F(EglX11, APixmapThatWasLeftIsNotWrittenAgain) {
    const Pixmap pixmap = make_pixmap(16, 8);
    const EGLSurface surface = eglCreatePixmapSurface(egl, egl_config, pixmap, nullptr);
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context));
    clear_to(0, 1, 1);
    EXPECT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    EXPECT_TRUE(shown(pixmap, 16, 8).is_all(pixel(false, true, true)));
    fill(pixmap, pixel(true, false, false), 16, 8);
    EXPECT_TRUE(eglDestroyContext(egl, context));
    EXPECT_TRUE(eglDestroySurface(egl, surface));
    EXPECT_TRUE(shown(pixmap, 16, 8).is_all(pixel(true, false, false)));
}

TEST_F(EglX11, APixmapFreedWhileCurrentRaisesNoError) {
    const Pixmap pixmap = make_pixmap(16, 8);
    const EGLSurface surface = eglCreatePixmapSurface(egl, egl_config, pixmap, nullptr);
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context));
    clear_to(0, 1, 1);
    glFinish();
    EXPECT_EQ(errors_of([&] {
                  eglDestroySurface(egl, surface);
                  XFreePixmap(display, pixmap);
                  clear_to(1, 0, 0);
                  glFinish();
                  eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
                  eglDestroyContext(egl, context);
              }),
              std::vector<int>());
}

TEST_F(EglX11, CopyBuffersFillsAPixmap) {
    const EGLSurface surface = draw_to_window();
    const int depth = DefaultDepth(display, DefaultScreen(display));
    const Pixmap pixmap = XCreatePixmap(display, window, 64, 48, unsigned(depth));
    clear_to(1, 0, 1);
    EXPECT_TRUE(eglCopyBuffers(egl, surface, pixmap));
    EXPECT_TRUE(shown(pixmap, 64, 48).is_all(pixel(true, false, true)));
    EXPECT_FALSE(eglCopyBuffers(egl, surface, 12345));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_PIXMAP);
}

TEST_F(EglX11, AClosedDisplayIsNotInitialized) {
    Display* const other = XOpenDisplay(nullptr);
    const EGLDisplay of_other = eglGetDisplay(EGLNativeDisplayType(other));
    ASSERT_TRUE(eglInitialize(of_other, nullptr, nullptr));
    XCloseDisplay(other);
    EXPECT_EQ(eglQueryString(of_other, EGL_VERSION), nullptr);
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
}

/// A thread has a context of GLX or one of EGL.
TEST_F(EglX11, AThreadHasOneContext) {
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    make_current(true);
    EXPECT_FALSE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    EXPECT_EQ(eglGetError(), EGL_BAD_ACCESS);
    const GLXContext of_glx = glXGetCurrentContext();
    const GLXDrawable drawable = glXGetCurrentDrawable();
    glXMakeCurrent(display, 0, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    const auto errors = errors_of([&] { glXMakeCurrent(display, drawable, of_glx); });
    EXPECT_EQ(errors, std::vector<int>{BadAccess});
    EXPECT_EQ(eglGetCurrentContext(), context);
}

}  // namespace
