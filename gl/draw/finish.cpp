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

namespace {

/// The active query, in a drawable; it goes on in the next one.
SampleCountRef active_count(const Context& context) {
    if (context.queries.active == 0 || context.drawable == nullptr ||
        !context.profile.extensions.occlusion_query)
        return nullptr;
    return context.queries.named.at(context.queries.active);
}

/// Ends the work of a context that will not be current.
void leave(Context& context) {
    finish_drawing(context, Cause::Switch);
    if (const SampleCountRef count = active_count(context)) context.drawable->end_count(count);
    if (context.drawable != nullptr) context.drawable->finish_counts();
}

}  // namespace

void make_current(Context* context, Drawable* draw, Drawable* read) {
    if (current != nullptr) guarded(*current, [] { leave(*current); });
    current = context;
    if (context == nullptr) return;
    context->drawable = draw;
    context->read_drawable = read;
    context->translated.changed = true;
    if (const SampleCountRef count = active_count(*context)) draw->begin_count(count);
    if (draw == nullptr || context->has_been_current) return;
    context->has_been_current = true;
    if (draw->is_double_buffered())
        context->state.color_buffer.draw_buffer = context->state.pixel.read_buffer = GL_BACK;
    context->state.viewport.width = context->state.scissor.box.width = draw->width();
    context->state.viewport.height = context->state.scissor.box.height = draw->height();
}

}  // namespace gw::gl
