// EGL's values of each thread: the current context and its surfaces, the API, the error.
#pragma once

#include "gl/egl/surface.h"

#include <memory>

namespace gw::gl::egl {

struct EglDisplay;

/// A context of OpenGL. EGL's handle is its address.
struct ClientContext {
    ClientContext(const Config& of, std::shared_ptr<Shared> shared)
        : config(of), context(settings().profile, std::move(shared)) {}

    const Config config;
    Context context;
    const Binding* holder = nullptr;  ///< the thread that it is current in
};

struct Binding {
    EglDisplay* display = nullptr;
    std::shared_ptr<ClientContext> context;
    std::shared_ptr<Surface> draw, read;
    EGLenum api = EGL_NONE;
    EGLint error = EGL_SUCCESS;

    /// Lets other threads have the context and the surfaces.
    void leave();
};
/// The calling thread's. When the thread ends, its context is left. A program's exit handlers, which
/// come later, find an empty one.
Binding& binding();

/// Draws what the thread's context has left, and leaves the thread without one.
void release_current();
/// Makes a context the calling thread's. Throws Failure if another thread has it, or a surface.
void take_current(EglDisplay& display, std::shared_ptr<ClientContext> context,
                  std::shared_ptr<Surface> draw, std::shared_ptr<Surface> read);

}  // namespace gw::gl::egl
