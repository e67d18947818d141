#include "gl/draw/finish.h"

#include "gl/context/current.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

namespace gw::gl {

void finish_drawing(Context& context, Cause cause) {
    flush_mesh(context);
    bool ended = false;
    if (context.shared->off_screen) ended |= context.shared->off_screen->finish(cause);
    if (context.window != nullptr) ended |= context.window->finish(cause);
    if (ended) context.calls.next = 0;
    context.meshes.begin_frame();
}

void finish_frame(Context& context) {
    flush_mesh(context);
    if (context.shared->off_screen) context.shared->off_screen->finish(Cause::Shown);
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
    finish_counts(context);
}

/// [GL11] tables 6.15 and 6.17. A context without a window may have bound framebuffer objects.
void begin_with_back_buffers(Context& context) {
    Framebuffers& f = context.framebuffers;
    (f.draw ? f.window_draw_buffer : context.state.color_buffer.draw_buffer) = GL_BACK;
    (f.read ? f.window_read_buffer : context.state.pixel.read_buffer) = GL_BACK;
}

}  // namespace

void make_current(Context* context, Drawable* draw, Drawable* read) {
    if (current != nullptr) guarded(*current, [] { leave(*current); });
    current = context;
    if (context == nullptr) return;
    context->window = draw;
    context->read_window = read;
    context->drawable = nullptr;  // leave() has ended the query in the former one
    choose_drawables(*context);
    context->translated.stale = all_state_parts;
    if (draw == nullptr || context->has_been_current) return;
    context->has_been_current = true;
    if (draw->is_double_buffered()) begin_with_back_buffers(*context);
    context->state.viewport.width = context->state.scissor.box.width = draw->width();
    context->state.viewport.height = context->state.scissor.box.height = draw->height();
}

}  // namespace gw::gl
