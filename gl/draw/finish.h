// Ends what a context draws: at Flush and Finish, at swaps, and when a thread gets another context.
#pragma once

#include "gl/context/context.h"

namespace gw::gl {

/// Draws what was assembled and executes the drawable's commands.
void finish_drawing(Context& context, Cause cause = Cause::Flush);
/// Draws what was assembled. The drawable's frame is to be swapped next.
void finish_frame(Context& context);

/// Binds a context and drawables to draw to and read from to the calling thread; all null: none.
/// Draws what the thread's former context has left. The first time, viewport and scissor box get the
/// drawable's size.
void make_current(Context* context, Drawable* draw, Drawable* read);
inline void make_current(Context* context, Drawable* drawable) {
    make_current(context, drawable, drawable);
}

}  // namespace gw::gl
