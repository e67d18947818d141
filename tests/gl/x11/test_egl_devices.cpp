// EGL's devices, and contexts without a surface. EGL_EXT_device_enumeration, EGL_EXT_device_query, EGL_EXT_platform_device
#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <array>

namespace {

template <class Function>
Function* named(const char* name) {
    return reinterpret_cast<Function*>(eglGetProcAddress(name));
}

/// As mujoco and PyOpenGL come in: device, display of the device, a context without a surface.
TEST(EglDevices, AreFoundAndDrawnWith) {
    const auto query_devices = named<decltype(eglQueryDevicesEXT)>("eglQueryDevicesEXT");
    const auto device_string = named<decltype(eglQueryDeviceStringEXT)>("eglQueryDeviceStringEXT");
    const auto display_attribute =
        named<decltype(eglQueryDisplayAttribEXT)>("eglQueryDisplayAttribEXT");
    ASSERT_NE(query_devices, nullptr);
    EGLint count = 0;
    EXPECT_TRUE(query_devices(0, nullptr, &count));
    EXPECT_EQ(count, 1);
    std::array<EGLDeviceEXT, 4> devices{};
    ASSERT_TRUE(query_devices(4, devices.data(), &count));
    ASSERT_EQ(count, 1);
    EXPECT_NE(devices[0], nullptr);
    EXPECT_EQ(devices[1], nullptr);
    EXPECT_FALSE(query_devices(0, devices.data(), &count));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_FALSE(query_devices(1, devices.data(), nullptr));
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    EXPECT_STREQ(device_string(devices[0], EGL_EXTENSIONS), "EGL_MESA_device_software");
    EXPECT_EQ(device_string(&count, EGL_EXTENSIONS), nullptr);
    EXPECT_EQ(eglGetError(), EGL_BAD_DEVICE_EXT);

    EXPECT_EQ(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, &count, nullptr), EGL_NO_DISPLAY);
    EXPECT_EQ(eglGetError(), EGL_BAD_PARAMETER);
    const EGLDisplay of_device =
        eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[0], nullptr);
    ASSERT_NE(of_device, EGL_NO_DISPLAY);
    EXPECT_NE(of_device, eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
    ASSERT_TRUE(eglInitialize(of_device, nullptr, nullptr));
    ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    EGLAttrib value = 0;
    EXPECT_TRUE(display_attribute(of_device, EGL_DEVICE_EXT, &value));
    EXPECT_EQ(value, reinterpret_cast<EGLAttrib>(devices[0]));
    const EGLint list[] = {EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_STENCIL_SIZE,
                           8,
                           EGL_COLOR_BUFFER_TYPE,
                           EGL_RGB_BUFFER,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_NONE};
    EGLConfig of_config = nullptr;
    ASSERT_TRUE(eglChooseConfig(of_device, list, &of_config, 1, &count));
    ASSERT_EQ(count, 1);
    const EGLContext context = eglCreateContext(of_device, of_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(of_device, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    EXPECT_NE(named<decltype(glGetString)>("glGetString")(GL_VERSION), nullptr);
    eglReleaseThread();
    eglTerminate(of_device);
}

/// GL_ARB_framebuffer_object, 4.4.4: without a surface there is no framebuffer 0.
TEST(EglWithoutASurface, DrawingAndReadingAreErrors) {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    ASSERT_TRUE(eglBindAPI(EGL_OPENGL_API));
    EGLConfig config = nullptr;
    EGLint count = 0;
    const EGLint list[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    ASSERT_TRUE(eglChooseConfig(display, list, &config, 1, &count));
    const EGLContext context = eglCreateContext(display, config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(display, nullptr, nullptr, context));
    std::array<GLubyte, 4> pixel{};
    const auto error_of = [](const auto& call) {
        call();
        return glGetError();
    };
    const GLenum wrong = 0x0506;  // GL_INVALID_FRAMEBUFFER_OPERATION
    EXPECT_EQ(error_of([] { glClear(GL_COLOR_BUFFER_BIT); }), wrong);
    EXPECT_EQ(error_of([] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 1, 0); }), wrong);
    EXPECT_EQ(error_of([&] { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data()); }),
              wrong);
    EXPECT_EQ(error_of([&] { glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data()); }),
              wrong);
    EXPECT_EQ(error_of([] {
                  glBegin(GL_POINTS);
                  glEnd();
              }),
              wrong);
    eglReleaseThread();
    eglTerminate(display);
}

}  // namespace
