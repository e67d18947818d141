// The names of framebuffer and renderbuffer objects, and what is bound. Framebuffers are a context's
// own, renderbuffers those of its share group. GL_ARB_framebuffer_object, 4.4.1, 4.4.2
#include "gl/api/calls.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"

namespace gw::gl {

namespace {

/// The machine of framebuffer objects is there from the first one on.
void need_machine(Context& context) {
    const auto lock = context.shared->exclusive();
    if (!context.shared->off_screen)
        context.shared->off_screen = std::make_shared<OffScreen>(context.profile);
}

/// The object of a name; made when it is bound first.
FramebufferRef framebuffer_of(Context& context, GLuint name) {
    if (name == 0) return nullptr;
    need_machine(context);
    FramebufferRef& object = context.framebuffers.named[name];
    if (!object) {
        object = std::make_shared<Framebuffer>();
        object->name = name;
    }
    return object;
}

void bind(Context& context, GLenum target, GLuint name) {
    const FramebufferRef object = framebuffer_of(context, name);
    if (target != GL_READ_FRAMEBUFFER) bind_draw_framebuffer(context, object);
    if (target != GL_DRAW_FRAMEBUFFER) bind_read_framebuffer(context, object);
}

bool is_framebuffer_target(GLenum target) {
    return target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER ||
           target == GL_READ_FRAMEBUFFER;
}

void bind_any_renderbuffer(Context& context, GLuint name) {
    if (name == 0) {
        context.framebuffers.renderbuffer = nullptr;
        return;
    }
    RenderbufferRef& object = context.shared->renderbuffers.named[name];
    if (!object) {
        object = std::make_shared<Renderbuffer>();
        object->name = name;
    }
    context.framebuffers.renderbuffer = object;
}

}  // namespace

namespace execute {

void gen_framebuffers(Context& context, GLsizei n, GLuint* framebuffers) {
    gen_names(context, context.framebuffers, n, framebuffers);
}

void gen_renderbuffers(Context& context, GLsizei n, GLuint* renderbuffers) {
    const auto lock = context.shared->exclusive();
    gen_names(context, context.shared->renderbuffers, n, renderbuffers);
}

void delete_framebuffers(Context& context, GLsizei n, const GLuint* framebuffers) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (framebuffers == nullptr) return;
    Framebuffers& f = context.framebuffers;
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = f.named.find(framebuffers[i]);
        if (found == f.named.end()) continue;
        const FramebufferRef object = found->second;
        if (object && object == f.draw) bind_draw_framebuffer(context, nullptr);
        if (object && object == f.read) bind_read_framebuffer(context, nullptr);
        f.named.erase(found);
        f.free_names.give_back(framebuffers[i]);
    }
}

void delete_renderbuffers(Context& context, GLsizei n, const GLuint* renderbuffers) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (renderbuffers == nullptr) return;
    const auto lock = context.shared->exclusive();
    auto& named = context.shared->renderbuffers.named;
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = named.find(renderbuffers[i]);
        if (found == named.end()) continue;
        const RenderbufferRef object = found->second;
        if (object) {
            detach(context, [&](const Attachment& a) { return a.renderbuffer == object; });
            if (context.framebuffers.renderbuffer == object)
                context.framebuffers.renderbuffer = nullptr;
        }
        named.erase(found);
        context.shared->renderbuffers.free_names.give_back(renderbuffers[i]);
    }
}

GLboolean is_framebuffer(Context& context, GLuint framebuffer) {
    const auto found = context.framebuffers.named.find(framebuffer);
    return found != context.framebuffers.named.end() && found->second ? GL_TRUE : GL_FALSE;
}

GLboolean is_renderbuffer(Context& context, GLuint renderbuffer) {
    const auto lock = context.shared->exclusive();
    const auto& named = context.shared->renderbuffers.named;
    const auto found = named.find(renderbuffer);
    return found != named.end() && found->second ? GL_TRUE : GL_FALSE;
}

void bind_framebuffer(Context& context, GLenum target, GLuint framebuffer) {
    if (!is_framebuffer_target(target)) return set_error(context, GL_INVALID_ENUM);
    if (framebuffer != 0 && !context.framebuffers.named.contains(framebuffer))
        return set_error(context, GL_INVALID_OPERATION);
    bind(context, target, framebuffer);
}

/// GL_EXT_framebuffer_object: a name may be any.
void bind_new_framebuffer(Context& context, GLenum target, GLuint framebuffer) {
    if (!is_framebuffer_target(target)) return set_error(context, GL_INVALID_ENUM);
    bind(context, target, framebuffer);
}

void bind_renderbuffer(Context& context, GLenum target, GLuint renderbuffer) {
    if (target != GL_RENDERBUFFER) return set_error(context, GL_INVALID_ENUM);
    const auto lock = context.shared->exclusive();
    if (renderbuffer != 0 && !context.shared->renderbuffers.named.contains(renderbuffer))
        return set_error(context, GL_INVALID_OPERATION);
    bind_any_renderbuffer(context, renderbuffer);
}

/// GL_EXT_framebuffer_object: a name may be any.
void bind_new_renderbuffer(Context& context, GLenum target, GLuint renderbuffer) {
    if (target != GL_RENDERBUFFER) return set_error(context, GL_INVALID_ENUM);
    const auto lock = context.shared->exclusive();
    bind_any_renderbuffer(context, renderbuffer);
}

}  // namespace execute

}  // namespace gw::gl
