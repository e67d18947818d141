// EGL's fences and images. A fence waits for nothing: CreateSync executes what was drawn. There are no
// images. [EGL 1.5] 3.8.1, 3.9
#include "gl/egl/displays.h"
#include "gl/egl/failure.h"

namespace {

using namespace gw::gl;
using namespace gw::gl::egl;

EGLAttrib sync_attribute(EGLint name) {
    switch (name) {
        case EGL_SYNC_TYPE: return EGL_SYNC_FENCE;
        case EGL_SYNC_STATUS: return EGL_SIGNALED;
        case EGL_SYNC_CONDITION: return EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
    }
    throw Failure{EGL_BAD_ATTRIBUTE};
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

EGLSync eglCreateSync(EGLDisplay handle, EGLenum type, const EGLAttrib* list) {
    return carried_out([&]() -> EGLSync {
        EglDisplay& display = initialized_display(handle);
        if (type != EGL_SYNC_FENCE) throw Failure{EGL_BAD_PARAMETER};
        if (list != nullptr && list[0] != EGL_NONE) throw Failure{EGL_BAD_ATTRIBUTE};
        if (!binding().context || binding().display != &display) throw Failure{EGL_BAD_MATCH};
        guarded(*current, [] { finish_drawing(*current); });
        return keep_new_sync(display);
    });
}

EGLBoolean eglDestroySync(EGLDisplay display, EGLSync sync) {
    return carried_out([&]() -> EGLBoolean {
        forget_sync(initialized_display(display), sync);
        return EGL_TRUE;
    });
}

EGLint eglClientWaitSync(EGLDisplay display, EGLSync sync, EGLint, EGLTime) {
    return carried_out([&]() -> EGLint {
        check_sync(initialized_display(display), sync);
        return EGL_CONDITION_SATISFIED;
    });
}

EGLBoolean eglWaitSync(EGLDisplay display, EGLSync sync, EGLint flags) {
    return carried_out([&]() -> EGLBoolean {
        check_sync(initialized_display(display), sync);
        if (flags != 0) throw Failure{EGL_BAD_PARAMETER};
        return EGL_TRUE;
    });
}

EGLBoolean eglGetSyncAttrib(EGLDisplay display, EGLSync sync, EGLint name, EGLAttrib* value) {
    return carried_out([&]() -> EGLBoolean {
        check_sync(initialized_display(display), sync);
        if (value == nullptr) throw Failure{EGL_BAD_PARAMETER};
        *value = sync_attribute(name);
        return EGL_TRUE;
    });
}

EGLImage eglCreateImage(EGLDisplay display, EGLContext, EGLenum, EGLClientBuffer,
                        const EGLAttrib*) {
    return carried_out([&]() -> EGLImage {
        initialized_display(display);
        throw Failure{EGL_BAD_PARAMETER};
    });
}

EGLBoolean eglDestroyImage(EGLDisplay display, EGLImage) {
    return carried_out([&]() -> EGLBoolean {
        initialized_display(display);
        throw Failure{EGL_BAD_PARAMETER};
    });
}

}  // extern "C"
#pragma GCC visibility pop
