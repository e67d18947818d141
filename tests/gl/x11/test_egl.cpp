// EGL without windows: displays, configurations, contexts, pbuffers, errors. [EGL 1.5]
#include <gtest/gtest.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>
#include <cstring>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace {

EGLDisplay surfaceless_display() {
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

/// A surfaceless display whose API is OpenGL.
class Egl : public testing::Test {
protected:
    void SetUp() override {
        display = surfaceless_display();
        ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
        ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
        const EGLint list[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
        EGLint count = 0;
        ASSERT_TRUE(eglChooseConfig(display, list, &config, 1, &count));
        ASSERT_EQ(count, 1);
    }
    void TearDown() override {
        eglReleaseThread();
        eglTerminate(display);
    }

    EGLContext make_context(std::vector<EGLint> list = {}, EGLContext share = nullptr) const {
        list.push_back(EGL_NONE);
        return eglCreateContext(display, config, share, list.data());
    }
    EGLSurface make_pbuffer(EGLint width, EGLint height) const {
        const EGLint list[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        return eglCreatePbufferSurface(display, config, list);
    }
    /// Makes a new context current on a new pbuffer.
    EGLSurface draw_to_pbuffer(EGLint width, EGLint height) const {
        const EGLSurface surface = make_pbuffer(width, height);
        EXPECT_TRUE(eglMakeCurrent(display, surface, surface, make_context()));
        return surface;
    }

    EGLDisplay display = nullptr;
    EGLConfig config = nullptr;
};

std::array<GLubyte, 4> pixel(int x, int y) {
    std::array<GLubyte, 4> rgba{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

constexpr std::array<GLubyte, 4> red{255, 0, 0, 255}, black{0, 0, 0, 0};

TEST_F(Egl, InitializeTellsTheVersion) {
    EGLint major = 0, minor = 0;
    ASSERT_TRUE(eglInitialize(display, &major, &minor));
    EXPECT_EQ(major, 1);
    EXPECT_EQ(minor, 5);
    EXPECT_STREQ(eglQueryString(display, EGL_VERSION), "1.5");
    EXPECT_STREQ(eglQueryString(display, EGL_CLIENT_APIS), "OpenGL");
    EXPECT_EQ(eglQueryString(display, EGL_NONE), nullptr);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
}

TEST_F(Egl, PlatformsAreExtensionsOfTheClient) {
    const std::string client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EXPECT_NE(client.find("EGL_MESA_platform_surfaceless"), std::string::npos);
    EXPECT_NE(client.find("EGL_KHR_platform_x11"), std::string::npos);
    const std::string own = eglQueryString(display, EGL_EXTENSIONS);
    EXPECT_NE(own.find("EGL_KHR_surfaceless_context"), std::string::npos);
}

TEST_F(Egl, ADisplayHasOneHandle) {
    EXPECT_EQ(surfaceless_display(), display);
    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, nullptr, nullptr), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
}

TEST_F(Egl, HandlesAreChecked) {
    int other = 0;
    EXPECT_FALSE(eglInitialize(&other, nullptr, nullptr));
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    EXPECT_EQ(eglCreateContext(display, &other, nullptr, nullptr), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONFIG);
    EXPECT_FALSE(eglDestroyContext(display, &other));
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
    EXPECT_FALSE(eglDestroySurface(display, &other));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_FALSE(eglDestroySync(display, &other));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglGetError(), EGL_SUCCESS);
}

TEST_F(Egl, AClosedDisplayKnowsNothing) {
    const EGLSurface surface = make_pbuffer(4, 4);
    ASSERT_TRUE(eglTerminate(display));
    EXPECT_FALSE(eglDestroySurface(display, surface));
    EXPECT_EQ(eglGetError(), EGL_NOT_INITIALIZED);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    EXPECT_FALSE(eglDestroySurface(display, surface));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

TEST_F(Egl, ErrorsBelongToTheThread) {
    EXPECT_FALSE(eglDestroySurface(display, nullptr));
    EGLint other = 0;
    std::thread([&] { other = eglGetError(); }).join();
    EXPECT_EQ(other, EGL_SUCCESS);
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

TEST_F(Egl, OpenGlEsIsNotOffered) {
    EXPECT_FALSE(eglBindAPI(EGL_OPENGL_ES_API));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_OPENGL_API));
    EXPECT_TRUE(eglReleaseThread());
    EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_NONE));
    EXPECT_EQ(make_context(), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    const EGLint list[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES2_BIT, EGL_NONE};
    EGLint count = -1;
    EXPECT_TRUE(eglChooseConfig(display, list, nullptr, 0, &count));
    EXPECT_EQ(count, 0);
}

TEST_F(Egl, ConfigurationsHaveTheBitsOfTheProfile) {
    const auto value = [&](EGLint name) {
        EGLint got = -1;
        EXPECT_TRUE(eglGetConfigAttrib(display, config, name, &got)) << name;
        return got;
    };
    EXPECT_EQ(value(EGL_BUFFER_SIZE), 32);
    EXPECT_EQ(value(EGL_DEPTH_SIZE), 24);
    EXPECT_EQ(value(EGL_STENCIL_SIZE), 8);
    EXPECT_EQ(value(EGL_RENDERABLE_TYPE), EGL_OPENGL_BIT);
    EXPECT_EQ(value(EGL_SURFACE_TYPE), EGL_PBUFFER_BIT);
    EXPECT_EQ(value(EGL_NATIVE_VISUAL_ID), 0);
    EGLint got = 0;
    EXPECT_FALSE(eglGetConfigAttrib(display, config, EGL_WIDTH, &got));
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
}

/// How many configurations a list matches, with PBUFFER_BIT; -1: an error.
class EglChoice : public Egl {
protected:
    EGLint count_of(std::vector<EGLint> list) const {
        list.insert(list.end(), {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE});
        EGLint count = 0;
        return eglChooseConfig(display, list.data(), nullptr, 0, &count) ? count : -1;
    }
};

TEST_F(EglChoice, FollowsTheTable) {
    constexpr int all = 2;  // of 0 and 4 samples
    EXPECT_EQ(count_of({}), all);
    EXPECT_EQ(count_of({EGL_RED_SIZE, 8, EGL_ALPHA_SIZE, 1, EGL_DEPTH_SIZE, 24}), all);
    EXPECT_EQ(count_of({EGL_RED_SIZE, 9}), 0);
    EXPECT_EQ(count_of({EGL_SAMPLES, 4}), 1);
    EXPECT_EQ(count_of({EGL_SAMPLES, 5}), 0);
    EXPECT_EQ(count_of({EGL_SAMPLE_BUFFERS, 1}), 1);
    EXPECT_EQ(count_of({EGL_SAMPLES, EGL_DONT_CARE}), all);
    EXPECT_EQ(count_of({EGL_LEVEL, 1}), 0);
    EXPECT_EQ(count_of({EGL_MAX_PBUFFER_WIDTH, 1}), all);
    EXPECT_EQ(count_of({EGL_CONFIG_ID, 1, EGL_RED_SIZE, 9}), 1);
    EXPECT_EQ(count_of({EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT}), all);
    // As the screen savers ask.
    EXPECT_EQ(count_of({EGL_RENDERABLE_TYPE, EGL_OPENGL_ES_BIT}), all);
    EGLint windows = -1;
    EXPECT_TRUE(eglChooseConfig(display, nullptr, nullptr, 0, &windows));
    EXPECT_EQ(windows, 0);
}

TEST_F(EglChoice, RefusesUnknownNamesAndValues) {
    for (const auto& [name, value] :
         std::vector<std::pair<EGLint, EGLint>>{{EGL_WIDTH, 1},
                                                {EGL_RED_SIZE, -2},
                                                {EGL_LEVEL, EGL_DONT_CARE},
                                                {EGL_CONFIG_CAVEAT, 7},
                                                {EGL_SURFACE_TYPE, 0x40000000},
                                                {EGL_RENDERABLE_TYPE, 0x100},
                                                {EGL_BIND_TO_TEXTURE_RGB, 2}}) {
        EXPECT_EQ(count_of({name, value}), -1) << name;
        EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE) << name;
    }
    EXPECT_FALSE(eglChooseConfig(display, nullptr, nullptr, 0, nullptr));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
}

TEST_F(Egl, AContextIsOfVersion1) {
    using List = std::vector<EGLint>;
    for (const List& list :
         {List{}, List{EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 1},
          List{EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 3},
          List{EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR}})
        EXPECT_NE(make_context(list), EGL_NO_CONTEXT);
    for (const List& list : {List{EGL_CONTEXT_MAJOR_VERSION, 2},
                             List{EGL_CONTEXT_MAJOR_VERSION, 1, EGL_CONTEXT_MINOR_VERSION, 6},
                             List{EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE, EGL_TRUE}}) {
        EXPECT_EQ(make_context(list), EGL_NO_CONTEXT);
        EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    }
    EXPECT_EQ(make_context({EGL_WIDTH, 1}), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    int other = 0;
    EXPECT_EQ(make_context({}, &other), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetError(), EGL_BAD_CONTEXT);
}

TEST_F(Egl, DrawsToAPbuffer) {
    const EGLSurface surface = draw_to_pbuffer(6, 4);
    GLint buffer = 0, box[4] = {};
    glGetIntegerv(GL_DRAW_BUFFER, &buffer);
    EXPECT_EQ(buffer, GL_BACK);
    glGetIntegerv(GL_VIEWPORT, box);
    EXPECT_EQ(box[2], 6);
    EXPECT_EQ(box[3], 4);
    glClearColor(1, 0, 0, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 3, 4);
    glClear(GL_COLOR_BUFFER_BIT);
    // A pbuffer keeps its picture.
    EXPECT_TRUE(eglSwapBuffers(display, surface));
    EXPECT_EQ(pixel(2, 3), red);
    EXPECT_EQ(pixel(3, 3), black);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(Egl, APbufferTellsItsAttributes) {
    const EGLSurface surface = make_pbuffer(6, 4);
    const auto value = [&](EGLint name) {
        EGLint got = -7;
        EXPECT_TRUE(eglQuerySurface(display, surface, name, &got)) << name;
        return got;
    };
    EXPECT_EQ(value(EGL_WIDTH), 6);
    EXPECT_EQ(value(EGL_HEIGHT), 4);
    EXPECT_EQ(value(EGL_CONFIG_ID), 1);
    EXPECT_EQ(value(EGL_RENDER_BUFFER), EGL_BACK_BUFFER);
    EXPECT_EQ(value(EGL_LARGEST_PBUFFER), EGL_FALSE);
    EXPECT_EQ(value(EGL_TEXTURE_FORMAT), EGL_NO_TEXTURE);
    EXPECT_EQ(value(EGL_SWAP_BEHAVIOR), EGL_BUFFER_DESTROYED);
    EXPECT_EQ(value(EGL_HORIZONTAL_RESOLUTION), EGL_UNKNOWN);
    EXPECT_TRUE(eglSurfaceAttrib(display, surface, EGL_MIPMAP_LEVEL, 2));
    EXPECT_EQ(value(EGL_MIPMAP_LEVEL), 2);
    EGLint got = 0;
    EXPECT_FALSE(eglQuerySurface(display, surface, EGL_RED_SIZE, &got));
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
    EXPECT_FALSE(eglSurfaceAttrib(display, surface, EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_FALSE(eglBindTexImage(display, surface, EGL_BACK_BUFFER));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
}

TEST_F(Egl, SizesOfPbuffersAreChecked) {
    EXPECT_EQ(make_pbuffer(-1, 4), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_EQ(make_pbuffer(5000, 4), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ALLOC);
    const EGLint list[] = {EGL_WIDTH, 5000, EGL_HEIGHT, 4, EGL_LARGEST_PBUFFER, EGL_TRUE, EGL_NONE};
    const EGLSurface largest = eglCreatePbufferSurface(display, config, list);
    EGLint width = 0;
    EXPECT_TRUE(eglQuerySurface(display, largest, EGL_WIDTH, &width));
    EXPECT_EQ(width, 4096);
    const EGLint wrong[] = {EGL_RENDER_BUFFER, EGL_BACK_BUFFER, EGL_NONE};
    EXPECT_EQ(eglCreatePbufferSurface(display, config, wrong), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_ATTRIBUTE);
}

TEST_F(Egl, AContextNeedsNoSurface) {
    const EGLContext context = make_context();
    ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
    glEndList();
    glClear(GL_COLOR_BUFFER_BIT);
    glRasterPos2f(0, 0);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
    glCopyPixels(0, 0, 1, 1, GL_COLOR);
    pixel(0, 0);
    glFinish();
    EGLint buffer = 0;
    EXPECT_TRUE(eglQueryContext(display, context, EGL_RENDER_BUFFER, &buffer));
    EXPECT_EQ(buffer, EGL_NONE);
    EXPECT_EQ(eglGetCurrentSurface(EGL_DRAW), EGL_NO_SURFACE);
    EXPECT_FALSE(eglSwapInterval(display, 0));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
}

TEST_F(Egl, MakeCurrentChecksWhatItGets) {
    const EGLSurface surface = make_pbuffer(4, 4);
    const EGLContext context = make_context();
    EXPECT_FALSE(eglMakeCurrent(display, surface, surface, EGL_NO_CONTEXT));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_FALSE(eglMakeCurrent(display, surface, EGL_NO_SURFACE, context));
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    EXPECT_FALSE(eglSwapBuffers(display, surface));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context));
    EXPECT_EQ(eglGetCurrentContext(), context);
    EXPECT_EQ(eglGetCurrentDisplay(), display);
    EXPECT_EQ(eglGetCurrentSurface(EGL_READ), surface);
    EXPECT_EQ(eglGetCurrentSurface(EGL_WIDTH), EGL_NO_SURFACE);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
    EXPECT_EQ(eglGetCurrentDisplay(), EGL_NO_DISPLAY);
}

TEST_F(Egl, AContextAndASurfaceBelongToOneThread) {
    const EGLSurface surface = draw_to_pbuffer(4, 4);
    const EGLContext context = eglGetCurrentContext();
    const EGLContext other = make_context();
    std::vector<EGLint> errors;
    std::thread([&] {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
        errors.push_back(eglGetError());
        eglMakeCurrent(display, surface, surface, other);
        errors.push_back(eglGetError());
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, other);
        errors.push_back(eglGetError());
        // The thread ends with a context.
    }).join();
    EXPECT_EQ(errors, (std::vector<EGLint>{EGL_BAD_ACCESS, EGL_BAD_ACCESS, EGL_SUCCESS}));
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, other));
}

TEST_F(Egl, WhatIsCurrentOutlivesItsDestruction) {
    const EGLSurface surface = draw_to_pbuffer(4, 4);
    EXPECT_TRUE(eglDestroyContext(display, eglGetCurrentContext()));
    EXPECT_TRUE(eglDestroySurface(display, surface));
    EXPECT_TRUE(eglTerminate(display));
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(pixel(3, 3), red);
}

TEST_F(Egl, ContextsShareTextures) {
    const EGLContext first = make_context(), second = make_context({}, first);
    ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, first));
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, second));
    EXPECT_TRUE(glIsTexture(name));
}

TEST_F(Egl, AFenceIsPassedAtOnce) {
    EXPECT_EQ(eglCreateSync(display, EGL_SYNC_FENCE, nullptr), EGL_NO_SYNC);
    EXPECT_EQ(eglGetError(), EGL_BAD_MATCH);
    draw_to_pbuffer(4, 4);
    EXPECT_EQ(eglCreateSync(display, EGL_SYNC_CL_EVENT, nullptr), EGL_NO_SYNC);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLSync sync = eglCreateSync(display, EGL_SYNC_FENCE, nullptr);
    ASSERT_NE(sync, EGL_NO_SYNC);
    EGLAttrib status = 0;
    EXPECT_TRUE(eglGetSyncAttrib(display, sync, EGL_SYNC_STATUS, &status));
    EXPECT_EQ(status, EGL_SIGNALED);
    EXPECT_EQ(eglClientWaitSync(display, sync, 0, EGL_FOREVER), EGL_CONDITION_SATISFIED);
    EXPECT_TRUE(eglWaitSync(display, sync, 0));
    EXPECT_TRUE(eglDestroySync(display, sync));
    EXPECT_FALSE(eglDestroySync(display, sync));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
}

TEST_F(Egl, FunctionsAreFoundByName) {
    EXPECT_EQ(eglGetProcAddress("glBegin"), reinterpret_cast<void (*)()>(&glBegin));
    EXPECT_EQ(eglGetProcAddress("eglSwapBuffers"), reinterpret_cast<void (*)()>(&eglSwapBuffers));
    EXPECT_NE(eglGetProcAddress("eglGetPlatformDisplayEXT"), nullptr);
    EXPECT_EQ(eglGetProcAddress("glNothing"), nullptr);
    EXPECT_EQ(eglGetProcAddress(nullptr), nullptr);
}

}  // namespace
