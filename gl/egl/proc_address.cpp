// GetProcAddress: functions of GL and of EGL by name. [EGL 1.5] 3.11
#define EGL_EGLEXT_PROTOTYPES
#include "gl/egl/egl.h"

#include "gl/egl/failure.h"
#include "gl/entry/entry_points.h"

#include <cstring>

namespace {

using gw::gl::Address;

struct EglFunction {
    const char* name;
    Address address;
};

template <class Function>
EglFunction egl_function(const char* name, Function* function) {
    return {name, reinterpret_cast<Address>(function)};
}

const EglFunction egl_functions[] = {
    egl_function("eglBindAPI", &eglBindAPI),
    egl_function("eglBindTexImage", &eglBindTexImage),
    egl_function("eglChooseConfig", &eglChooseConfig),
    egl_function("eglClientWaitSync", &eglClientWaitSync),
    egl_function("eglCopyBuffers", &eglCopyBuffers),
    egl_function("eglCreateContext", &eglCreateContext),
    egl_function("eglCreateImage", &eglCreateImage),
    egl_function("eglCreatePbufferFromClientBuffer", &eglCreatePbufferFromClientBuffer),
    egl_function("eglCreatePbufferSurface", &eglCreatePbufferSurface),
    egl_function("eglCreatePixmapSurface", &eglCreatePixmapSurface),
    egl_function("eglCreatePlatformPixmapSurface", &eglCreatePlatformPixmapSurface),
    egl_function("eglCreatePlatformPixmapSurfaceEXT", &eglCreatePlatformPixmapSurfaceEXT),
    egl_function("eglCreatePlatformWindowSurface", &eglCreatePlatformWindowSurface),
    egl_function("eglCreatePlatformWindowSurfaceEXT", &eglCreatePlatformWindowSurfaceEXT),
    egl_function("eglCreateSync", &eglCreateSync),
    egl_function("eglCreateWindowSurface", &eglCreateWindowSurface),
    egl_function("eglDestroyContext", &eglDestroyContext),
    egl_function("eglDestroyImage", &eglDestroyImage),
    egl_function("eglDestroySurface", &eglDestroySurface),
    egl_function("eglDestroySync", &eglDestroySync),
    egl_function("eglGetConfigAttrib", &eglGetConfigAttrib),
    egl_function("eglGetConfigs", &eglGetConfigs),
    egl_function("eglGetCurrentContext", &eglGetCurrentContext),
    egl_function("eglGetCurrentDisplay", &eglGetCurrentDisplay),
    egl_function("eglGetCurrentSurface", &eglGetCurrentSurface),
    egl_function("eglGetDisplay", &eglGetDisplay),
    egl_function("eglGetError", &eglGetError),
    egl_function("eglGetPlatformDisplay", &eglGetPlatformDisplay),
    egl_function("eglGetPlatformDisplayEXT", &eglGetPlatformDisplayEXT),
    egl_function("eglGetProcAddress", &eglGetProcAddress),
    egl_function("eglGetSyncAttrib", &eglGetSyncAttrib),
    egl_function("eglInitialize", &eglInitialize),
    egl_function("eglMakeCurrent", &eglMakeCurrent),
    egl_function("eglQueryAPI", &eglQueryAPI),
    egl_function("eglQueryContext", &eglQueryContext),
    egl_function("eglQueryDeviceAttribEXT", &eglQueryDeviceAttribEXT),
    egl_function("eglQueryDeviceStringEXT", &eglQueryDeviceStringEXT),
    egl_function("eglQueryDevicesEXT", &eglQueryDevicesEXT),
    egl_function("eglQueryDisplayAttribEXT", &eglQueryDisplayAttribEXT),
    egl_function("eglQueryString", &eglQueryString),
    egl_function("eglQuerySurface", &eglQuerySurface),
    egl_function("eglReleaseTexImage", &eglReleaseTexImage),
    egl_function("eglReleaseThread", &eglReleaseThread),
    egl_function("eglSurfaceAttrib", &eglSurfaceAttrib),
    egl_function("eglSwapBuffers", &eglSwapBuffers),
    egl_function("eglSwapInterval", &eglSwapInterval),
    egl_function("eglTerminate", &eglTerminate),
    egl_function("eglWaitClient", &eglWaitClient),
    egl_function("eglWaitGL", &eglWaitGL),
    egl_function("eglWaitNative", &eglWaitNative),
    egl_function("eglWaitSync", &eglWaitSync),
};

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    return gw::gl::egl::carried_out([&]() -> Address {
        if (name == nullptr) return nullptr;
        for (const EglFunction& function : egl_functions)
            if (std::strcmp(function.name, name) == 0) return function.address;
        return gw::gl::find_entry_point(name);
    });
}

}  // extern "C"
#pragma GCC visibility pop
