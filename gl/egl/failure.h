// Errors of EGL. [EGL 1.5] 3.1
#pragma once

#include "gl/egl/current.h"

#include <cstdio>
#include <new>

namespace gw::gl::egl {

/// Ends a function of EGL with an error.
struct Failure {
    EGLint code;
};

/// Carries out a function of EGL: GetError returns SUCCESS afterwards, or the error that ended it.
/// The result is then 0.
template <class Call>
auto carried_out(Call call) -> decltype(call()) {
    EGLint& error = binding().error;
    try {
        error = EGL_SUCCESS;
        return call();
    } catch (const Failure& failure) {
        error = failure.code;
    } catch (const std::bad_alloc&) {
        error = EGL_BAD_ALLOC;
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "gw: %s\n", exception.what());
        error = EGL_BAD_ALLOC;
    }
    return decltype(call())();
}

}  // namespace gw::gl::egl
