// BlitFramebuffer. GL_ARB_framebuffer_object, 4.3.3. Within one machine it is a Blit of each plane.
// From another machine the planes are read and written to a surface first.
#include "gl/api/calls.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/pixels/read.h"
#include "gw/stages/resolve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace gw::gl {

namespace {

constexpr GLbitfield known_buffers =
    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;

/// One axis: two corners of the source and of the target.
struct Axis {
    std::int64_t from0, from1, to0, to1;

    bool is_flipped() const { return (from0 > from1) != (to0 > to1); }
    bool is_empty() const { return from0 == from1 || to0 == to1; }
    std::int64_t from() const { return std::min(from0, from1); }
    std::int64_t from_size() const { return std::abs(from1 - from0); }
    std::int64_t to() const { return std::min(to0, to1); }
    std::int64_t to_size() const { return std::abs(to1 - to0); }
    /// Leaves out what lies outside both framebuffers, if no pixel is scaled.
    Axis clipped() const;
    bool fits() const {
        const auto is_near = [](std::int64_t v) { return std::abs(v) <= max_surface_size; };
        return is_near(from()) && is_near(to()) && from_size() <= max_surface_size &&
               to_size() <= max_surface_size;
    }
};

Axis Axis::clipped() const {
    if (from_size() != to_size() || is_flipped()) return *this;
    const std::int64_t skipped = std::max({std::int64_t{0}, -from(), -to()});
    const std::int64_t size =
        std::min({from_size() - skipped, max_surface_size - (from() + skipped),
                  max_surface_size - (to() + skipped)});
    if (size <= 0) return {0, 0, 0, 0};
    return {from() + skipped, from() + skipped + size, to() + skipped, to() + skipped + size};
}

/// The rectangles of a call; none if no pixel is copied.
std::optional<gw::Blit> rectangles(const Axis& x, const Axis& y, GLenum filter) {
    if (x.is_empty() || y.is_empty()) return std::nullopt;
    if (!x.fits() || !y.fits()) {
        std::fprintf(stderr,
                     "gw: warning: glBlitFramebuffer scales rectangles beyond -8192 to 8192, which "
                     "the machine cannot; nothing is copied\n");
        return std::nullopt;
    }
    return gw::Blit{
        .source = {int(x.from()), int(y.from()), int(x.from_size()), int(y.from_size())},
        .target = {int(x.to()), int(y.to()), int(x.to_size()), int(y.to_size())},
        .flip_x = x.is_flipped(),
        .flip_y = y.is_flipped(),
        .filter = filter == GL_LINEAR ? MagFilter::Linear : MagFilter::Nearest};
}

/// The planes that both framebuffers have.
PlaneMask copied_planes(const Context& context, GLbitfield mask) {
    PlaneMask planes = 0;
    if (mask & GL_COLOR_BUFFER_BIT) planes |= mask_of(Plane::Color);
    if (mask & GL_DEPTH_BUFFER_BIT) planes |= mask_of(Plane::Depth);
    if (mask & GL_STENCIL_BUFFER_BIT) planes |= mask_of(Plane::Stencil);
    const auto keep = [&](Plane plane, bool has) {
        if (!has) planes &= PlaneMask(~mask_of(plane));
    };
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil}) {
        const FramebufferRef& from = context.framebuffers.read;
        keep(plane, !from || from->at(plane).is_given());
    }
    keep(Plane::Color, context.state.pixel.read_buffer != GL_NONE &&
                           context.state.color_buffer.draw_buffer != GL_NONE);
    return planes & drawn_planes(context);
}

/// A plane of what is read, as a whole.
struct ReadPlane {
    int width, height, depth_bits;
    std::vector<Rgba> colors;
    std::vector<std::uint32_t> values;
};

/// A plane with samples is resolved first.
Readback read_resolved(Context& context, Plane plane, const Rect& all) {
    if (!context.framebuffers.read || read_samples(context) == 0)
        return read_raw(context, plane, all);
    const TargetLock lock = lock_target(context, *context.read_drawable);
    OffScreen& machine = *context.shared->off_screen;
    SurfaceImage image(
        context.shared->off_screen,
        {.width = all.width, .height = all.height, .depth_bits = read_depth_bits(context)}, false);
    const ImagePlane to{&image, plane};
    const std::uint32_t from = read_surface(context, plane);
    machine.write_from(to, from);
    return machine.read_plane(to, Cause::Copy);
}

ReadPlane whole_plane(Context& context, Plane plane) {
    const FramebufferSize size = read_size(context);
    ReadPlane out{size.width, size.height, read_depth_bits(context), {}, {}};
    Readback read = read_resolved(context, plane, {0, 0, size.width, size.height});
    out.colors = std::move(read.color);
    out.values.assign(read.values.begin(), read.values.end());
    return out;
}

/// Blits a plane that was read to an object. Its surface is in use.
void blit_to_object(Context& context, gw::Blit blit, Plane plane, ReadPlane read) {
    SurfaceImage image(context.shared->off_screen,
                       {.width = read.width, .height = read.height, .depth_bits = read.depth_bits},
                       false);
    image.machine->write({&image, plane}, std::move(read.colors), std::move(read.values));
    blit.from_surface = image.surface(plane);
    submit_command(context, blit);
}

/// The same to the window, by a surface that is there only meanwhile.
void blit_to_window(Context& context, gw::Blit blit, Plane plane, ReadPlane read) {
    Drawable& window = *context.drawable;
    const auto lock = window.exclusive();
    const PausedCounts paused(window);
    const Surface surface{read.width, read.height, mask_of(plane),
                          plane == Plane::Depth ? read.depth_bits : 0};
    constexpr std::uint32_t passing = WindowSamples::surface + 1;
    window.set_state(gw::State());
    window.add(MakeSurface{passing, surface});
    window.add(UseSurface{passing});
    window.hold(read.colors.size() * sizeof(Rgba) + read.values.size() * sizeof(std::uint32_t));
    window.add(WritePixels{.rect = {0, 0, read.width, read.height},
                           .plane = plane,
                           .colors = std::move(read.colors),
                           .values = std::move(read.values)});
    window.add(UseSurface{0});
    blit.from_surface = passing;
    submit_command(context, blit);
    window.add(MakeSurface{passing, {}});
}

/// Alpha of an image without alpha is 1.
void make_opaque(Context& context, const Rect& target) {
    const auto image = attached_image(context.framebuffers.draw->at(Plane::Color));
    if (base_format(image->internal_format) != GL_RGB) return;
    const TargetLock lock = lock_target(context, *context.drawable);
    use_draw_surface(context);
    update_machine_state(context);
    gw::State state = context.translated.state;
    state.color_mask = {false, false, false, true};
    state.scissor = {true, state.scissor.test ? intersect(state.scissor.box, target) : target};
    context.drawable->set_state(state);
    context.drawable->add(gw::Clear{.planes = mask_of(Plane::Color), .color = {0, 0, 0, 1}});
}

void blit_plane(Context& context, gw::Blit blit, Plane plane) {
    blit.planes = mask_of(plane);
    const Framebuffers& f = context.framebuffers;
    if (context.read_drawable != context.drawable) {
        ReadPlane read = whole_plane(context, plane);
        f.draw ? blit_to_object(context, blit, plane, std::move(read))
               : blit_to_window(context, blit, plane, std::move(read));
    } else if (f.draw) {
        const TargetLock lock = lock_target(context, *context.drawable);
        use_draw_surface(context);  // planes that both have are where they are drawn to
        blit.from_surface = read_surface(context, plane);
        submit_command(context, blit);
    } else {
        submit_command(context, blit);
    }
    if (f.draw && plane == Plane::Color) make_opaque(context, blit.target);
}

/// With samples, pixels are not scaled, and both have as many.
bool suits_samples(const Context& context, const Axis& x, const Axis& y) {
    const int from = read_samples(context), to = draw_samples(context);
    if (from == 0 && to == 0) return true;
    return (from == 0 || to == 0 || from == to) && x.from_size() == x.to_size() &&
           y.from_size() == y.to_size();
}

bool has_equal_depths(const Context& context, PlaneMask planes) {
    return (planes & mask_of(Plane::Depth)) == 0 ||
           draw_depth_bits(context) == read_depth_bits(context);
}

}  // namespace

namespace execute {

void blit_framebuffer(Context& context, GLint src_x0, GLint src_y0, GLint src_x1, GLint src_y1,
                      GLint dst_x0, GLint dst_y0, GLint dst_x1, GLint dst_y1, GLbitfield mask,
                      GLenum filter) {
    if (mask & ~known_buffers) return set_error(context, GL_INVALID_VALUE);
    if (filter != GL_NEAREST && filter != GL_LINEAR) return set_error(context, GL_INVALID_ENUM);
    if (filter == GL_LINEAR && (mask & ~GLbitfield{GL_COLOR_BUFFER_BIT}) != 0)
        return set_error(context, GL_INVALID_OPERATION);
    flush_mesh(context);
    if (!can_draw(context) || !can_read(context)) return;
    if (context.drawable == nullptr || context.read_drawable == nullptr)
        return set_error(context, GL_INVALID_FRAMEBUFFER_OPERATION);
    const PlaneMask planes = copied_planes(context, mask);
    if (!has_equal_depths(context, planes)) return set_error(context, GL_INVALID_OPERATION);
    const Axis x{src_x0, src_x1, dst_x0, dst_x1}, y{src_y0, src_y1, dst_y0, dst_y1};
    if (!suits_samples(context, x, y)) return set_error(context, GL_INVALID_OPERATION);
    const auto blit = rectangles(x.clipped(), y.clipped(), filter);
    if (!blit || context.selection.mode != GL_RENDER) return;
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        if (planes & mask_of(plane)) blit_plane(context, *blit, plane);
}

}  // namespace execute

}  // namespace gw::gl
