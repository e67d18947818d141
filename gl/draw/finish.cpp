#include "gl/draw/finish.h"

#include "gl/context/current.h"
#include "gl/draw/submit.h"

namespace gw::gl {

void finish_drawing(Context& c, Cause cause) {
    flush_mesh(c);
    if (c.drawable == nullptr) return;
    if (c.drawable->finish(cause)) c.calls.next = 0;
    c.meshes.begin_frame();
}

void finish_frame(Context& c) {
    flush_mesh(c);
    c.meshes.begin_frame();
    c.calls.next = 0;
}

void make_current(Context* context, Drawable* draw, Drawable* read) {
    if (current != nullptr) guarded(*current, [] { finish_drawing(*current, Cause::Switch); });
    current = context;
    if (context == nullptr) return;
    context->drawable = draw;
    context->read_drawable = read;
    context->translated.changed = true;
    if (draw == nullptr || context->has_been_current) return;
    context->has_been_current = true;
    if (draw->is_double_buffered())
        context->state.color_buffer.draw_buffer = context->state.pixel.read_buffer = GL_BACK;
    context->state.viewport.width = context->state.scissor.box.width = draw->width();
    context->state.viewport.height = context->state.scissor.box.height = draw->height();
}

}  // namespace gw::gl
