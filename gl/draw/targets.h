// Where a context draws and what it reads: its window, or framebuffer objects on the machine of the
// share group. Textures whose images framebuffer objects drew to. GL_ARB_framebuffer_object
#pragma once

#include "gl/context/context.h"
#include "gw/command_list.h"

#include <mutex>

namespace gw::gl {

/// CheckFramebufferStatus of an object; null: of the window.
GLenum framebuffer_status(const Context& context, const FramebufferRef& framebuffer);
/// Whether the object that is drawn to is complete. The window is, or draws nothing.
bool is_draw_complete(const Context& context);
/// Whether it is complete; else the error INVALID_FRAMEBUFFER_OPERATION.
bool can_draw(Context& context);
bool can_read(Context& context);
/// Whether the framebuffer that is read has a plane, and is no object with samples. Else, or if it is
/// not complete, the error.
bool can_read(Context& context, Plane plane);

/// Binds framebuffers; null: the window. Queries go on where the context draws then.
void bind_draw_framebuffer(Context& context, FramebufferRef framebuffer);
void bind_read_framebuffer(Context& context, FramebufferRef framebuffer);
void detach(Context& context, Attachment& attachment);
/// Removes attachments of deleted objects from the framebuffers that are bound.
template <class Is>
void detach(Context& context, Is is) {
    for (const FramebufferRef& framebuffer : {context.framebuffers.draw, context.framebuffers.read})
        if (framebuffer)
            for (Attachment& attachment : framebuffer->attachments)
                if (is(attachment)) detach(context, attachment);
}
/// After a change of the windows.
void choose_drawables(Context& context);

/// Executes the commands of both machines if counts wait for them.
void finish_counts(Context& context);

/// GL_MAX_SAMPLES.
int most_samples(const Context& context);
/// GL_SAMPLES of the framebuffer that is drawn to or read from.
int draw_samples(const Context& context);
int read_samples(const Context& context);

/// The bits of a depth in the framebuffer that is drawn to or read from; 0: it has none.
int draw_depth_bits(const Context& context);
int read_depth_bits(const Context& context);
FramebufferSize read_size(const Context& context);

/// Nobody else draws on the machine, or changes textures, as long as it lives.
struct TargetLock {
    std::unique_lock<std::recursive_mutex> shared, drawable;
};
TargetLock lock_target(Context& context, Drawable& drawable);

/// The planes of the framebuffer that is drawn to; Accum is the window's.
PlaneMask drawn_planes(const Context& context);

/// Brings the planes of the object that is drawn to together, and uses their surface. The caller
/// holds a TargetLock; the object is complete.
void use_draw_surface(Context& context);
/// Its images are newer than their texels from here on.
void note_drawing(Context& context);
/// The surface of a plane that the object that is read has.
std::uint32_t read_surface(Context& context, Plane plane);

/// The texture of a unit for a draw to a framebuffer object: a plane of its machine, or texels.
TextureBinding plane_or_texels(Context& context, std::size_t unit);
/// Brings the texels of a texture up to what framebuffer objects drew.
void update_texels(Context& context, TextureObject& object);

}  // namespace gw::gl
