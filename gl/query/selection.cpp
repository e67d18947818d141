// RenderMode, the name stack, and the buffers. [GL11] 5.2, 5.3
#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include <algorithm>
#include <cmath>

namespace gw::gl {

namespace {

/// A depth 0 .. 1 as an integer 0 .. 2^32 - 1.
GLuint depth_word(double depth) {
    return GLuint(std::floor(std::clamp(depth, 0.0, 1.0) * 4294967295.0 + 0.5));
}

/// Writes a hit record if the names had a hit since the last one.
void end_hit(Context& context) {
    Selection& s = context.selection;
    if (!s.hit) return;
    s.hit = false;
    ++s.hit_count;
    const auto put = [&](GLuint word) {
        if (s.hits_used < s.hits_size)
            s.hits[s.hits_used++] = word;
        else
            s.overflow = true;
    };
    put(GLuint(s.names.size()));
    put(depth_word(s.nearest));
    put(depth_word(s.farthest));
    for (const GLuint name : s.names) put(name);
}

/// Ends the hits of the names so far, before they change.
void begin_name_change(Context& context) {
    flush_mesh(context);
    end_hit(context);
}

/// The result of a mode that ends.
GLint mode_result(Context& context) {
    Selection& s = context.selection;
    if (s.mode == GL_SELECT) {
        end_hit(context);
        return s.overflow ? -1 : s.hit_count;
    }
    if (s.mode == GL_FEEDBACK) return s.overflow ? -1 : s.feedback_used;
    return 0;
}

bool is_feedback_type(GLenum type) { return type >= GL_2D && type <= GL_4D_COLOR_TEXTURE; }

}  // namespace

namespace execute {

// Outside of selection, names are ignored. A call that is an error writes no hit record.

void init_names(Context& context) {
    if (context.selection.mode != GL_SELECT) return;
    begin_name_change(context);
    context.selection.names.clear();
}

void load_name(Context& context, GLuint name) {
    if (context.selection.mode != GL_SELECT) return;
    if (context.selection.names.empty()) return set_error(context, GL_INVALID_OPERATION);
    begin_name_change(context);
    context.selection.names.back() = name;
}

void push_name(Context& context, GLuint name) {
    if (context.selection.mode != GL_SELECT) return;
    if (context.selection.names.size() >= name_stack_depth)
        return set_error(context, GL_STACK_OVERFLOW);
    begin_name_change(context);
    context.selection.names.push_back(name);
}

void pop_name(Context& context) {
    if (context.selection.mode != GL_SELECT) return;
    if (context.selection.names.empty()) return set_error(context, GL_STACK_UNDERFLOW);
    begin_name_change(context);
    context.selection.names.pop_back();
}

GLint render_mode(Context& context, GLenum mode) {
    Selection& s = context.selection;
    if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK)
        return set_error(context, GL_INVALID_ENUM), 0;
    if ((mode == GL_SELECT && !s.has_hits) || (mode == GL_FEEDBACK && !s.has_feedback))
        return set_error(context, GL_INVALID_OPERATION), 0;
    begin_change(context);
    const GLint result = mode_result(context);
    s.mode = mode;
    s.hits_used = s.hit_count = s.feedback_used = 0;
    s.hit = s.overflow = false;
    s.names.clear();
    return result;
}

void select_buffer(Context& context, GLsizei size, GLuint* buffer) {
    if (size < 0) return set_error(context, GL_INVALID_VALUE);
    if (context.selection.mode == GL_SELECT) return set_error(context, GL_INVALID_OPERATION);
    context.selection.has_hits = true;
    context.selection.hits = buffer;
    context.selection.hits_size = buffer != nullptr ? size : 0;
}

void feedback_buffer(Context& context, GLsizei size, GLenum type, GLfloat* buffer) {
    if (size < 0 || (buffer == nullptr && size > 0)) return set_error(context, GL_INVALID_VALUE);
    if (!is_feedback_type(type)) return set_error(context, GL_INVALID_ENUM);
    if (context.selection.mode == GL_FEEDBACK) return set_error(context, GL_INVALID_OPERATION);
    context.selection.has_feedback = true;
    context.selection.feedback = buffer;
    context.selection.feedback_size = size;
    context.selection.feedback_type = type;
}

void pass_through(Context& context, GLfloat token) {
    Selection& s = context.selection;
    if (s.mode != GL_FEEDBACK) return;
    flush_mesh(context);
    for (const float value : {float(GL_PASS_THROUGH_TOKEN), token}) {
        if (s.feedback_used < s.feedback_size)
            s.feedback[s.feedback_used++] = value;
        else
            s.overflow = true;
    }
}

}  // namespace execute

}  // namespace gw::gl
