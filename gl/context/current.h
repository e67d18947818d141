// The current context of each thread, and the numbers of its calls.
#pragma once

#include "gl/drawable/call_trace.h"

namespace gw::gl {

struct Context;

/// Null: none. In the thread's static block, since every GL call reads it.
[[gnu::tls_model("initial-exec")]] extern constinit thread_local Context* current;

/// Sets CallTrace::now of the current context.
void keep_call(Function function, const void* source);

/// At the beginning of each entry point; `source` is its return address.
inline void number_call(Function function, const void* source) {
    if (calls_are_kept) [[unlikely]]
        keep_call(function, source);
}

}  // namespace gw::gl
