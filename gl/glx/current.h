// GLX's contexts, and each thread's current one. [GLX 1.4] 3.3.7
#pragma once

#include "gl/glx/surface.h"

#include <memory>

struct __GLXcontextRec {
    __GLXcontextRec(Display* display, const gw::gl::glx::Config& config,
                    std::shared_ptr<gw::gl::Shared> shared);

    Display* const display;
    const gw::gl::glx::Config config;
    const XID name;
    gw::gl::Context context;
    bool is_current = false;    ///< in some thread
    bool is_destroyed = false;  ///< by the program; goes when no thread has it any more
};

namespace gw::gl::glx {

/// What a thread draws to and reads from.
struct Current {
    Display* display = nullptr;
    GLXContext context = nullptr;
    XID draw_name = 0, read_name = 0;
    std::shared_ptr<Surface> draw, read;

    /// Lets other threads have the context.
    void leave();
};
/// The calling thread's. When the thread ends, its context is left. A program's exit handlers, which
/// come later, find an empty one.
Current& current_binding();

/// Keeps a new context until destroy_context().
GLXContext keep_context(std::unique_ptr<__GLXcontextRec> context);
/// Whether a program's pointer is a context. A destroyed one is, for the thread that has it.
bool is_context(GLXContext context);
void destroy_context(GLXContext context);

/// Whether exit handlers run that were registered before the program's first context.
bool has_exit_begun();

/// Makes a context the calling thread's; false if another thread has it.
bool take_context(GLXContext context);
/// Draws what the thread's context has left, and leaves the thread without one.
void release_current();

}  // namespace gw::gl::glx
