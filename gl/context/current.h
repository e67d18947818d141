// The current context of each thread, and the numbers of its calls.
#pragma once

#include "gl/drawable/call_trace.h"

namespace gw::gl {

struct Context;

/// Null: none. In the thread's static block, since every GL call reads it.
[[gnu::tls_model("initial-exec")]] extern constinit thread_local Context* current;

/// The current context of the other library of ours in this process. A program may be linked with
/// libGL.so.1 and draw with a context of libOSMesa.so.8, or look its functions up in the wrong one.
/// Null: none, or the libraries are not of one build.
Context* context_of_other_library();

/// The context that GL's functions of this library use. Null: none.
inline Context* bound_context() {
    Context* const own = current;
    return own != nullptr ? own : context_of_other_library();
}

/// The call of an interface above OpenGL that is being carried out: what OpenGL draws meanwhile is its
/// work. Null: none.
extern constinit thread_local const CallPlace* outer_call;

/// Sets CallTrace::now of the context: the outer call, else this one.
void keep_call(Function function, const void* source);

/// At the beginning of each entry point; `source` is its return address.
inline void number_call(Function function, const void* source) {
    if (calls_are_kept) [[unlikely]]
        keep_call(function, source);
}

}  // namespace gw::gl
