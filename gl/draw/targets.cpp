#include "gl/draw/targets.h"

#include "gl/draw/submit.h"
#include "gw/base/arithmetic.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <utility>
#include <vector>

namespace gw::gl {

namespace {

constexpr std::array attachable{Plane::Color, Plane::Depth, Plane::Stencil};

OffScreen& off_screen(const Context& context) { return *context.shared->off_screen; }

SurfaceImageRef new_image(const Context& context, const AttachedImage& of) {
    const GLint format = of.internal_format;
    return std::make_shared<SurfaceImage>(
        context.shared->off_screen,
        Surface{.width = of.width,
                .height = of.height,
                .depth_bits = depth_bits_of(context.profile, format),
                .samples = of.samples},
        base_format(format) == GL_RGB);
}

/// The image of an attachment, made when it is needed first. Precondition: the attachment is complete.
SurfaceImage& image_of(const Context& context, const Attachment& a) {
    SurfaceImageRef& image =
        a.renderbuffer ? a.renderbuffer->image : a.texture->rendered[a.place].image;
    if (!image) image = new_image(context, *attached_image(a));
    return *image;
}

/// A depth of `from` bits in `to` bits.
std::uint32_t as_depth(std::uint32_t depth, int from, int to) {
    return from == to ? depth : rescale(depth, from, to);
}

/// The values of a plane that the texels of a slice have.
void write_texels(OffScreen& to, const ImagePlane& plane, const TextureImage& from, int slice,
                  int color_bits, int stencil_bits) {
    const std::size_t count = std::size_t(from.width) * std::size_t(from.height);
    const std::uint16_t* texel = from.texels.data() + 4 * count * std::size_t(slice);
    std::vector<Rgba> colors(plane.plane == Plane::Color ? count : 0);
    for (Rgba& color : colors)
        for (std::uint16_t& channel : color)
            channel = static_cast<std::uint16_t>(rescale(*texel++, 16, color_bits));
    std::vector<std::uint32_t> values(plane.plane == Plane::Color ? 0 : count);
    for (std::uint32_t& value : values) {
        const std::uint32_t depth = std::uint32_t{texel[0]} << 16 | texel[1];
        value = plane.plane == Plane::Depth ? as_depth(depth, 32, plane.image->depth_bits)
                                            : texel[2] & ((1u << stencil_bits) - 1);
        texel += 4;
    }
    to.write(plane, std::move(colors), std::move(values));
}

/// Brings a plane up to texels that were given.
void update_plane(const Context& context, const Attachment& a, const ImagePlane& plane) {
    if (!a.texture) return;
    RenderedImage& rendered = a.texture->rendered.at(a.place);
    if ((rendered.older & mask_of(plane.plane)) == 0) return;
    rendered.older &= PlaneMask(~mask_of(plane.plane));
    const TextureImage& image = a.texture->image(a.place.key);
    if (image.texels.size() != 0)
        write_texels(off_screen(context), plane, image, a.place.slice, context.profile.color_bits,
                     context.profile.stencil_bits);
}

Drawable* drawable_of(const Context& context, const FramebufferRef& object, Drawable* window) {
    return object ? context.shared->off_screen.get() : window;
}

/// The active query goes on in the new drawable.
void draw_to(Context& context, Drawable* to) {
    Drawable* const from = std::exchange(context.drawable, to);
    if (from == to || context.queries.active == 0 || !context.profile.extensions.occlusion_query)
        return;
    const SampleCountRef& count = context.queries.named.at(context.queries.active);
    if (from != nullptr) from->end_count(count);
    if (to != nullptr) to->begin_count(count);
}

bool is_complete(const Context& context, const FramebufferRef& framebuffer) {
    return framebuffer_status(context, framebuffer) == GL_FRAMEBUFFER_COMPLETE;
}

bool is_complete_or_error(Context& context, const FramebufferRef& framebuffer) {
    if (is_complete(context, framebuffer)) return true;
    set_error(context, GL_INVALID_FRAMEBUFFER_OPERATION);
    return false;
}

int depth_bits(const Context& context, const FramebufferRef& framebuffer) {
    if (!framebuffer) return context.profile.depth_bits;
    const auto image = attached_image(framebuffer->at(Plane::Depth));
    return image ? depth_bits_of(context.profile, image->internal_format) : 0;
}

int samples(const FramebufferRef& framebuffer, const Drawable* window) {
    if (!framebuffer) return window != nullptr ? window->samples() : 0;
    for (const Attachment& a : framebuffer->attachments)
        if (const auto image = attached_image(a)) return image->samples;
    return 0;
}

}  // namespace

GLenum framebuffer_status(const Context& context, const FramebufferRef& framebuffer) {
    if (framebuffer) return status_of(*framebuffer, context.profile);
    return context.window != nullptr ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_UNDEFINED;
}

bool is_draw_complete(const Context& context) {
    return is_complete(context, context.framebuffers.draw);
}
bool can_draw(Context& context) { return is_complete_or_error(context, context.framebuffers.draw); }
bool can_read(Context& context) { return is_complete_or_error(context, context.framebuffers.read); }

bool can_read(Context& context, Plane plane) {
    if (!can_read(context)) return false;
    const FramebufferRef& f = context.framebuffers.read;
    const bool is_off = plane == Plane::Color && context.state.pixel.read_buffer == GL_NONE;
    const bool has_plane = !f || (f->at(plane).is_given() && read_samples(context) == 0);
    if (!is_off && has_plane) return true;
    set_error(context, GL_INVALID_OPERATION);
    return false;
}

PlaneMask drawn_planes(const Context& context) {
    if (!context.framebuffers.draw) return all_planes;
    PlaneMask out = 0;
    for (const Plane plane : attachable)
        if (context.framebuffers.draw->at(plane).is_given()) out |= mask_of(plane);
    return out;
}

void choose_drawables(Context& context) {
    draw_to(context, drawable_of(context, context.framebuffers.draw, context.window));
    context.read_drawable = drawable_of(context, context.framebuffers.read, context.read_window);
}

void bind_draw_framebuffer(Context& context, FramebufferRef framebuffer) {
    Framebuffers& f = context.framebuffers;
    if (framebuffer == f.draw) return;
    begin_change(context);
    GLenum& now = context.state.color_buffer.draw_buffer;
    (f.draw ? f.draw->draw_buffer : f.window_draw_buffer) = now;
    f.draw = std::move(framebuffer);
    now = f.draw ? f.draw->draw_buffer : f.window_draw_buffer;
    choose_drawables(context);
}

void bind_read_framebuffer(Context& context, FramebufferRef framebuffer) {
    Framebuffers& f = context.framebuffers;
    if (framebuffer == f.read) return;
    begin_change(context);
    GLenum& now = context.state.pixel.read_buffer;
    (f.read ? f.read->read_buffer : f.window_read_buffer) = now;
    f.read = std::move(framebuffer);
    now = f.read ? f.read->read_buffer : f.window_read_buffer;
    choose_drawables(context);
}

void detach(Context& context, Attachment& attachment) {
    begin_change(context);
    attachment = {};
}

int most_samples(const Context& context) {
    return context.profile.extensions.multisample ? max_samples : 0;
}

int draw_samples(const Context& context) {
    return samples(context.framebuffers.draw, context.window);
}
int read_samples(const Context& context) {
    return samples(context.framebuffers.read, context.read_window);
}

void finish_counts(Context& context) {
    if (context.shared->off_screen) context.shared->off_screen->finish_counts();
    if (context.window != nullptr) context.window->finish_counts();
}

int draw_depth_bits(const Context& context) {
    return depth_bits(context, context.framebuffers.draw);
}
int read_depth_bits(const Context& context) {
    return depth_bits(context, context.framebuffers.read);
}

FramebufferSize read_size(const Context& context) {
    if (context.framebuffers.read) return size_of(*context.framebuffers.read);
    return {context.read_drawable->width(), context.read_drawable->height()};
}

TargetLock lock_target(Context& context, Drawable& drawable) {
    TargetLock out;
    if (&drawable == context.shared->off_screen.get()) out.shared = context.shared->exclusive();
    out.drawable = drawable.exclusive();
    return out;
}

namespace {

/// Textures give their surfaces back; their texels have everything.
void release_surfaces(Context& context) {
    for (auto& [name, named] : context.shared->textures.named) {
        if (!named.object) continue;
        update_texels(context, *named.object);
        named.object->rendered.clear();
    }
}

}  // namespace

void use_draw_surface(Context& context) {
    const Framebuffer& framebuffer = *context.framebuffers.draw;
    if (off_screen(context).is_full()) release_surfaces(context);
    std::vector<ImagePlane> planes;
    for (const Plane plane : attachable)
        if (const Attachment& a = framebuffer.at(plane); a.is_given())
            planes.push_back({&image_of(context, a), plane});
    OffScreen& machine = off_screen(context);
    const std::uint32_t surface = machine.gather(planes);
    for (const ImagePlane& plane : planes)
        update_plane(context, framebuffer.at(plane.plane), plane);
    machine.use(surface);
}

void note_drawing(Context& context) {
    for (const Plane plane : attachable)
        if (const Attachment& a = context.framebuffers.draw->at(plane); a.texture)
            a.texture->rendered.at(a.place).newer |= mask_of(plane);
}

std::uint32_t read_surface(Context& context, Plane plane) {
    const Attachment& a = context.framebuffers.read->at(plane);
    const ImagePlane of{&image_of(context, a), plane};
    const std::uint32_t surface = off_screen(context).surface_of(of, false);
    update_plane(context, a, of);
    return surface;
}

namespace {

bool is_drawn_to(const Context& context, const TextureObject& object, const ImageSlice& place) {
    return std::ranges::any_of(context.framebuffers.draw->attachments, [&](const Attachment& a) {
        return a.texture.get() == &object && a.place == place;
    });
}

void warn_of_feedback(GLuint texture, GLuint framebuffer) {
    static std::atomic_flag warned;
    if (warned.test_and_set()) return;
    std::fprintf(stderr,
                 "gw: warning: texture %u is sampled while framebuffer %u draws to it; each draw "
                 "samples what was there before it\n",
                 texture, framebuffer);
}

/// Whether the machine makes the same of a surface's plane as of the texels: it has four channels,
/// those of a shadow comparison the same value.
bool equals_plane(const TextureUnit& unit, const TextureObject& object) {
    const TextureParameters& p = object.parameters;
    const GLint format = object.base().internal_format;
    if (p.min_filter != GL_NEAREST && p.min_filter != GL_LINEAR) return false;
    if (is_depths(format))
        return p.compare_mode == GL_COMPARE_R_TO_TEXTURE && p.depth_mode == GL_INTENSITY &&
               unit.env_mode != GL_BLEND;
    if (is_srgb(format)) return false;
    return base_format(format) == GL_RGBA || unit.env_mode != GL_REPLACE;
}

/// The plane that a texture of two dimensions is, if it is one.
std::optional<SurfacePlane> plane_of(Context& context, std::size_t unit, TextureObject& object) {
    const ImageSlice place{{0, object.base_level()}, 0};
    const auto found = object.rendered.find(place);
    if (found == object.rendered.end() || !equals_plane(context.state.texture.units[unit], object))
        return std::nullopt;
    if (is_drawn_to(context, object, place)) {
        warn_of_feedback(context.state.texture.units[unit].bound[two_dimensions],
                         context.framebuffers.draw->name);
        return std::nullopt;
    }
    const Plane plane = is_depths(object.base().internal_format) ? Plane::Depth : Plane::Color;
    SurfaceImage* const image = found->second.image.get();
    if ((found->second.older & mask_of(plane)) != 0 || image->surface(plane) == 0)
        return std::nullopt;
    return SurfacePlane{off_screen(context).surface_of({image, plane}, true), plane};
}

/// Stores a plane that was read in the texels of a slice.
void store(const Readback& read, const ImagePlane& plane, int color_bits, std::uint16_t* texel) {
    const std::uint32_t factor =
        16 % color_bits == 0 ? max_of_bits(16) / max_of_bits(color_bits) : 0;
    for (const Rgba& color : read.color)
        for (const std::uint16_t channel : color)
            *texel++ =
                std::uint16_t(factor != 0 ? channel * factor : rescale(channel, color_bits, 16));
    for (const std::uint32_t value : read.values) {
        if (plane.plane == Plane::Stencil) {
            texel[2] = static_cast<std::uint16_t>(value);
        } else {
            const std::uint32_t depth = as_depth(value, plane.image->depth_bits, 32);
            texel[0] = static_cast<std::uint16_t>(depth >> 16);
            texel[1] = static_cast<std::uint16_t>(depth);
        }
        texel += 4;
    }
}

}  // namespace

void update_texels(Context& context, TextureObject& object) {
    const auto lock = context.shared->exclusive();
    for (auto& [place, rendered] : object.rendered) {
        const PlaneMask newer = std::exchange(rendered.newer, PlaneMask{0});
        if (newer == 0) continue;
        TextureImage& image = object.image(place.key);
        image.fill();
        image.blocks = nullptr;
        object.made = nullptr;
        object.changed = true;
        object.history = {};
        for (const Plane plane : attachable) {
            if ((newer & mask_of(plane)) == 0) continue;
            const ImagePlane of{rendered.image.get(), plane};
            const Readback read = rendered.image->machine->read_plane(of, Cause::Texture);
            store(read, of, context.profile.color_bits,
                  image.texels.edit().data() +
                      pixel_index(0, image.height * place.slice, image.width) * 4);
        }
    }
}

TextureBinding plane_or_texels(Context& context, std::size_t unit) {
    const auto target = enabled_target(context.state.texture.units[unit]);
    if (!target) return {};
    TextureObject& object = *context.textures.bound[unit][*target];
    if (*target == two_dimensions)
        if (const auto plane = plane_of(context, unit, object)) return {.surface = plane};
    return {.texture = enabled_texture(context, unit)};
}

}  // namespace gw::gl
