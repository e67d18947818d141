// The current context of each thread.
#pragma once

namespace gw::gl {

struct Context;

/// Null: none. In the thread's static block, since every GL call reads it.
[[gnu::tls_model("initial-exec")]] extern constinit thread_local Context* current;

}  // namespace gw::gl
