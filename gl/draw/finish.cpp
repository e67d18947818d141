#include "gl/draw/finish.h"

#include "gl/context/current.h"
#include "gl/draw/submit.h"

namespace gw::gl {

void finish_drawing(Context& context, Cause cause) {
    flush_mesh(context);
    if (context.drawable == nullptr) return;
    if (context.drawable->finish(cause)) context.calls.next = 0;
    context.meshes.begin_frame();
}

void finish_frame(Context& context) {
    flush_mesh(context);
    context.meshes.begin_frame();
    context.calls.next = 0;
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
