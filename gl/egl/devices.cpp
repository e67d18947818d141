// The one device: the machine. EGL_EXT_device_enumeration, EGL_EXT_device_query,
// EGL_EXT_platform_device
#define EGL_EGLEXT_PROTOTYPES
#include "gl/egl/displays.h"
#include "gl/egl/failure.h"

#include <algorithm>

namespace gw::gl::egl {

EGLDeviceEXT machine_device() {
    static char device = 0;
    return &device;
}

namespace {

void check_device(EGLDeviceEXT device) {
    if (device != machine_device()) throw Failure{EGL_BAD_DEVICE_EXT};
}

}  // namespace

}  // namespace gw::gl::egl

using namespace gw::gl::egl;

#pragma GCC visibility push(default)
extern "C" {

EGLBoolean eglQueryDevicesEXT(EGLint size, EGLDeviceEXT* devices, EGLint* count) {
    return carried_out([&]() -> EGLBoolean {
        if (count == nullptr || (devices != nullptr && size <= 0)) throw Failure{EGL_BAD_PARAMETER};
        if (devices != nullptr) *devices = machine_device();
        *count = 1;
        return EGL_TRUE;
    });
}

const char* eglQueryDeviceStringEXT(EGLDeviceEXT device, EGLint name) {
    return carried_out([&]() -> const char* {
        check_device(device);
        if (name != EGL_EXTENSIONS) throw Failure{EGL_BAD_PARAMETER};
        return "EGL_MESA_device_software";
    });
}

EGLBoolean eglQueryDeviceAttribEXT(EGLDeviceEXT device, EGLint, EGLAttrib*) {
    return carried_out([&]() -> EGLBoolean {
        check_device(device);
        throw Failure{EGL_BAD_ATTRIBUTE};
    });
}

EGLBoolean eglQueryDisplayAttribEXT(EGLDisplay handle, EGLint name, EGLAttrib* value) {
    return carried_out([&]() -> EGLBoolean {
        initialized_display(handle);
        if (name != EGL_DEVICE_EXT) throw Failure{EGL_BAD_ATTRIBUTE};
        if (value == nullptr) throw Failure{EGL_BAD_PARAMETER};
        *value = reinterpret_cast<EGLAttrib>(machine_device());
        return EGL_TRUE;
    });
}

}  // extern "C"
#pragma GCC visibility pop
