// EGL's functions of contexts, of the API and of waiting. [EGL 1.5] 3.7, 3.8, 3.9
#include "gl/egl/displays.h"
#include "gl/egl/failure.h"

#include <utility>

namespace {

using namespace gw::gl;
using namespace gw::gl::egl;

/// The attributes of a new context.
struct WantedContext {
    EGLint major = 1, minor = 0;
    bool forward_compatible = false;
    EGLint profile = EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
};

constexpr EGLint known_flags = EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR |
                               EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR |
                               EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR;

/// Debug contexts and checked accesses need nothing: the machine checks always.
WantedContext read_context_list(const EGLint* list) {
    WantedContext wanted;
    for (; list != nullptr && list[0] != EGL_NONE; list += 2) {
        switch (list[0]) {
            case EGL_CONTEXT_MAJOR_VERSION: wanted.major = list[1]; break;
            case EGL_CONTEXT_MINOR_VERSION: wanted.minor = list[1]; break;
            case EGL_CONTEXT_OPENGL_PROFILE_MASK: wanted.profile = list[1]; break;
            case EGL_CONTEXT_FLAGS_KHR:
                if ((list[1] & ~known_flags) != 0) throw Failure{EGL_BAD_ATTRIBUTE};
                wanted.forward_compatible |=
                    (list[1] & EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR) != 0;
                break;
            case EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE:
                wanted.forward_compatible |= list[1] != EGL_FALSE;
                break;
            case EGL_CONTEXT_OPENGL_DEBUG:
            case EGL_CONTEXT_OPENGL_ROBUST_ACCESS:
            case EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY: break;
            default: throw Failure{EGL_BAD_ATTRIBUTE};
        }
    }
    return wanted;
}

/// Versions to 1.5, also where a profile has less: programs of screen savers ask for 1.3 and do without.
bool is_offered(const WantedContext& wanted) {
    return wanted.major == 1 && wanted.minor >= 0 && wanted.minor <= 5 &&
           !wanted.forward_compatible;
}

EGLContext create_context(EGLDisplay handle, EGLConfig config_handle, EGLContext share_handle,
                          const EGLint* list) {
    EglDisplay& display = initialized_display(handle);
    // [EGL 1.5] 3.7.1: without an API that is there.
    if (binding().api != EGL_OPENGL_API) throw Failure{EGL_BAD_MATCH};
    const Config& config = config_of(display, config_handle);
    std::shared_ptr<Shared> shared;
    if (share_handle != EGL_NO_CONTEXT) shared = context_of(display, share_handle)->context.shared;
    if (const WantedContext wanted = read_context_list(list); !is_offered(wanted)) {
        report_refused_context(wanted.major, wanted.minor);
        throw Failure{EGL_BAD_MATCH};
    }
    return keep(display, std::make_shared<ClientContext>(config, std::move(shared)));
}

/// The surface of a handle in MakeCurrent; null: none.
std::shared_ptr<Surface> surface_or_none(EglDisplay& display, EGLSurface handle) {
    return handle == EGL_NO_SURFACE ? nullptr : surface_of(display, handle);
}

void leave_context(EGLDisplay handle, EGLSurface draw, EGLSurface read) {
    EglDisplay& display = known_display(handle);
    if (draw != EGL_NO_SURFACE || read != EGL_NO_SURFACE)
        throw Failure{display.is_initialized ? EGL_BAD_MATCH : EGL_NOT_INITIALIZED};
    release_current();
}

void make_context_current(EGLDisplay handle, EGLSurface draw, EGLSurface read, EGLContext context) {
    if (context == EGL_NO_CONTEXT) return leave_context(handle, draw, read);
    EglDisplay& display = initialized_display(handle);
    auto draw_surface = surface_or_none(display, draw);
    auto read_surface = surface_or_none(display, read);
    auto wanted = context_of(display, context);
    if (!draw_surface != !read_surface) throw Failure{EGL_BAD_MATCH};
    // The thread has a context of GLX.
    if (current != nullptr && !binding().context) throw Failure{EGL_BAD_ACCESS};
    take_current(display, std::move(wanted), std::move(draw_surface), std::move(read_surface));
}

EGLBoolean wait_for_drawing() {
    if (binding().context) guarded(*current, [] { finish_drawing(*current); });
    return EGL_TRUE;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

EGLBoolean eglBindAPI(EGLenum api) {
    return carried_out([&]() -> EGLBoolean {
        if (api != EGL_OPENGL_API) throw Failure{EGL_BAD_PARAMETER};
        binding().api = api;
        return EGL_TRUE;
    });
}

EGLenum eglQueryAPI() { return binding().api; }

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                            const EGLint* list) {
    return carried_out([&] { return create_context(display, config, share, list); });
}

EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
    return carried_out([&]() -> EGLBoolean {
        forget_context(initialized_display(display), context);
        return EGL_TRUE;
    });
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read,
                          EGLContext context) {
    return carried_out([&]() -> EGLBoolean {
        make_context_current(display, draw, read, context);
        return EGL_TRUE;
    });
}

EGLBoolean eglQueryContext(EGLDisplay display, EGLContext handle, EGLint name, EGLint* value) {
    return carried_out([&]() -> EGLBoolean {
        const auto context = context_of(initialized_display(display), handle);
        if (value == nullptr) throw Failure{EGL_BAD_PARAMETER};
        const bool draws = context == binding().context && binding().draw;
        switch (name) {
            case EGL_CONFIG_ID: *value = context->config.id; break;
            case EGL_CONTEXT_CLIENT_TYPE: *value = EGL_OPENGL_API; break;
            case EGL_CONTEXT_CLIENT_VERSION: *value = 1; break;
            case EGL_RENDER_BUFFER:
                *value = draws ? binding().draw->render_buffer() : EGL_NONE;
                break;
            default: throw Failure{EGL_BAD_ATTRIBUTE};
        }
        return EGL_TRUE;
    });
}

EGLContext eglGetCurrentContext() { return binding().context.get(); }

EGLSurface eglGetCurrentSurface(EGLint which) {
    return carried_out([&]() -> EGLSurface {
        if (which != EGL_DRAW && which != EGL_READ) throw Failure{EGL_BAD_PARAMETER};
        return which == EGL_DRAW ? binding().draw.get() : binding().read.get();
    });
}

EGLDisplay eglGetCurrentDisplay() { return binding().display; }

EGLBoolean eglWaitClient() { return carried_out(&wait_for_drawing); }
EGLBoolean eglWaitGL() { return carried_out(&wait_for_drawing); }

EGLBoolean eglWaitNative(EGLint engine) {
    return carried_out([&]() -> EGLBoolean {
        if (engine != EGL_CORE_NATIVE_ENGINE) throw Failure{EGL_BAD_PARAMETER};
        const EglDisplay* const display = binding().display;
        if (display != nullptr && display->native != nullptr) XSync(display->native, False);
        return EGL_TRUE;
    });
}

EGLBoolean eglReleaseThread() {
    return carried_out([&]() -> EGLBoolean {
        release_current();
        binding().api = EGL_NONE;
        return EGL_TRUE;
    });
}

}  // extern "C"
#pragma GCC visibility pop
