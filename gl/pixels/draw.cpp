// DrawPixels, Bitmap, CopyPixels: rectangles at the raster position. [GL11] 3.6.4, 3.7, 4.3.3
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/machine_state.h"
#include "gl/draw/report.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/pieces.h"
#include "gl/pixels/read.h"
#include "gl/pixels/transfer.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/resolve.h"

#include <algorithm>
#include <cmath>

namespace gw::gl {

namespace {

/// The bits of a fragment's depth, also where no plane keeps it.
int fragment_depth_bits(const Context& context) {
    const int bits = draw_depth_bits(context);
    return bits != 0 ? bits : context.profile.depth_bits;
}

/// Texture coordinates of a unit as the machine's.
vec4 machine_texcoord(const Context& context, std::size_t unit, vec4 texcoord) {
    const dvec2 scale = coordinate_scale(context, unit);
    if (scale == dvec2(1)) return texcoord;
    for (int i = 0; i < 2; ++i)
        texcoord[i] =
            float(rectangle_coordinate(double(texcoord[i]), double(texcoord.w), scale[i]));
    return texcoord;
}

RasterPosition raster_position(const Context& context) {
    const CurrentState::Raster& raster = context.state.current.raster;
    MoreTexcoords further = raster.further_texcoords;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        further[unit - 1] = machine_texcoord(context, unit, further[unit - 1]);
    return {.x = raster.position.x,
            .y = raster.position.y,
            .depth = quantize(raster.position.z, fragment_depth_bits(context)),
            .color = quantize_color(raster.color, context.profile.color_bits),
            .texcoord = machine_texcoord(context, 0, raster.texcoord),
            .distance = std::max(raster.distance, 0.0),
            .secondary_color =
                quantize_color(vec4(raster.secondary_color, 0), context.profile.color_bits),
            .fog_coordinate = raster.distance,
            .more_texcoords = further};
}

/// A rectangle at the raster position, without its pixels.
gw::DrawPixels rectangle(Context& context, GLsizei width, GLsizei height) {
    gw::DrawPixels out;
    out.width = width;
    out.height = height;
    out.raster = raster_position(context);
    out.zoom_x = context.state.pixel.zoom_x;
    out.zoom_y = context.state.pixel.zoom_y;
    if (context.framebuffers.draw) return out;  // submit_command() knows the planes
    out.map.texture = enabled_texture(context);
    out.more_maps = further_textures(context);
    return out;
}

/// Whether a copy of the machine can name a rectangle of the window. No pixel of it may be inside.
bool is_nameable(const Rect& r) {
    const auto is_near = [](GLint at) { return at >= -max_window_size && at <= max_window_size; };
    return is_near(r.x) && is_near(r.y) && r.width <= max_window_size &&
           r.height <= max_window_size;
}

/// Whether a rectangle draws: not in feedback, which gets `token`, nor in selection.
bool is_drawn(Context& context, GLenum token) {
    if (!can_draw(context) || !context.state.current.raster.valid) return false;
    flush_mesh(context);
    if (context.selection.mode == GL_RENDER) return context.drawable != nullptr;
    report_raster_position(context, token);
    return false;
}

void set_depths(gw::DrawPixels& out, const Context& context, const std::vector<double>& depths) {
    const int bits = fragment_depth_bits(context);
    out.depths.reserve(depths.size());
    for (const double depth : depths) out.depths.push_back(quantize(depth, bits));
}
void set_stencils(gw::DrawPixels& out, const Context& context,
                  const std::vector<GLuint>& stencils) {
    const GLuint mask = (1u << context.profile.stencil_bits) - 1;
    for (const GLuint stencil : stencils) out.stencils.push_back(stencil & mask);
}

/// Whether pixel transfer leaves the values of a plane as they are.
bool is_identity(const PixelState& s, Plane plane) {
    if (plane == Plane::Depth) return s.depth_scale == 1 && s.depth_bias == 0;
    if (plane == Plane::Stencil) return leaves_stencils(s);
    return leaves_colors(s);
}

/// Whether the machine has what is read where it draws.
bool reads_what_it_draws(const Context& context) {
    return context.read_drawable == context.drawable &&
           context.framebuffers.read == context.framebuffers.draw && draw_samples(context) == 0;
}

/// The pixels of a copy, read and transferred by the front end.
void set_transferred(gw::DrawPixels& out, Context& context, Plane plane, const Rect& rect) {
    if (plane == Plane::Color) {
        out.colors = read_rgba(context, rect, Cause::Copy, context.profile.color_bits);
        return;
    }
    std::vector<double> values = read_values(context, plane, rect, Cause::Copy);
    if (plane == Plane::Depth) {
        for (double& depth : values) depth = transferred_depth(context, depth);
        return set_depths(out, context, values);
    }
    std::vector<GLuint> stencils;
    for (const double v : values) stencils.push_back(transferred_stencil(context, v));
    set_stencils(out, context, stencils);
}

/// Bits as runs of the raster colour.
WriteSpans as_spans(const gw::DrawPixels& pixels, int x, int y) {
    WriteSpans out;
    out.colors = {pixels.raster.color};
    out.depth = pixels.raster.depth;
    for (int row = 0; row < pixels.height; ++row)
        for (int i = 0; i < pixels.width; ++i) {
            const std::size_t byte = std::size_t(row) * pixels.bit_row() + std::size_t(i) / 8;
            if ((pixels.bits[byte] >> (7 - i % 8) & 1) != 0)
                out.spans.push_back({.x = x + i, .y = y + row, .length = 1});
        }
    return out;
}

/// A rectangle as commands of a profile without the extension draw_pixels: no zoom, texture or fog.
Command plain(const gw::DrawPixels& pixels) {
    const auto first = [](double v) { return int(std::clamp(std::ceil(v - 0.5), -4096., 4096.)); };
    const int x = first(pixels.raster.x), y = first(pixels.raster.y);
    const Rect rect{x, y, pixels.width, pixels.height};
    if (pixels.source)
        return Copy{pixels.source->plane,
                    {pixels.source->x, pixels.source->y, pixels.width, pixels.height},
                    x,
                    y};
    if (!pixels.bits.empty()) return as_spans(pixels, x, y);
    if (!pixels.colors.empty())
        return WritePixels{.rect = rect, .colors = pixels.colors, .depth = pixels.raster.depth};
    if (!pixels.depths.empty())
        return WritePixels{.rect = rect, .plane = Plane::Depth, .values = pixels.depths};
    return WritePixels{.rect = rect, .plane = Plane::Stencil, .values = pixels.stencils};
}

/// While it exists, depths are written without tests, and no colours: pixels of GL_DEPTH_STENCIL are
/// no fragments. EXT_packed_depth_stencil, 3.6.4
class Untested {
public:
    explicit Untested(Context& context) : context_(context), before_(context.state) {
        begin_change(context, fragment_part);
        context.state.stencil.test = context.state.color_buffer.alpha_test = false;
        context.state.color_buffer.mask.fill(false);
        context.state.depth.test = true;
        context.state.depth.func = GL_ALWAYS;
    }
    ~Untested() {
        begin_change(context_, fragment_part);
        context_.state = before_;
    }
    Untested(const Untested&) = delete;
    Untested& operator=(const Untested&) = delete;

private:
    Context& context_;
    const State before_;
};

void add_rectangle(Context& context, gw::DrawPixels pixels) {
    if (context.profile.extensions.draw_pixels) return submit_command(context, std::move(pixels));
    if (pixels.zoom_x != 1 || pixels.zoom_y != 1) return set_error(context, GL_INVALID_OPERATION);
    submit_command(context, plain(pixels));
}

void add_rectangle_of_any_size(Context& context, gw::DrawPixels pixels) {
    for_each_piece(std::move(pixels),
                   [&](gw::DrawPixels piece) { add_rectangle(context, std::move(piece)); });
}

void draw_depths_and_stencils(Context& context, GLsizei width, GLsizei height,
                              const HostImage& image) {
    const DepthsAndStencils host = host_depths_and_stencils(context, width, height, image);
    gw::DrawPixels stencils = rectangle(context, width, height);
    set_stencils(stencils, context, host.stencils);
    add_rectangle_of_any_size(context, std::move(stencils));
    const Untested untested(context);
    gw::DrawPixels depths = rectangle(context, width, height);
    set_depths(depths, context, host.depths);
    add_rectangle_of_any_size(context, std::move(depths));
}

/// Pixels outside the window are not drawn, so they can be left out.
void copy_plane(Context& context, Plane plane, const Rect& whole) {
    const Rect rect = is_nameable(whole) ? whole : part_inside(context, whole);
    if (rect.area() == 0) return;
    gw::DrawPixels out = rectangle(context, rect.width, rect.height);
    out.raster.x += out.zoom_x * (double(rect.x) - double(whole.x));
    out.raster.y += out.zoom_y * (double(rect.y) - double(whole.y));
    if (is_identity(context.state.pixel, plane) && reads_what_it_draws(context))
        out.source = PixelSource{plane, rect.x, rect.y};
    else
        set_transferred(out, context, plane, rect);
    add_rectangle(context, std::move(out));
}

/// Whether the framebuffers have the planes of a copy.
bool can_copy(Context& context, GLenum type) {
    if (!can_draw(context)) return false;
    const auto has = [&](Plane plane) {
        const bool draws = (drawn_planes(context) & mask_of(plane)) != 0;
        if (!draws && plane != Plane::Color) set_error(context, GL_INVALID_OPERATION);
        return (draws || plane == Plane::Color) && can_read(context, plane);
    };
    if (type == GL_COLOR) return has(Plane::Color);
    return (type == GL_STENCIL || has(Plane::Depth)) && (type == GL_DEPTH || has(Plane::Stencil));
}

}  // namespace

namespace execute {

void draw_pixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const HostImage& image) {
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    if (!is_drawn(context, GL_DRAW_PIXEL_TOKEN) || !image.is_given()) return;
    if (format == GL_DEPTH_STENCIL) return draw_depths_and_stencils(context, width, height, image);
    gw::DrawPixels out = rectangle(context, width, height);
    if (format == GL_DEPTH_COMPONENT)
        set_depths(out, context, host_depths(context, width, height, type, image));
    else if (format == GL_STENCIL_INDEX)
        set_stencils(out, context, host_stencils(context, width, height, type, image));
    else
        out.colors =
            host_rgba(context, width, height, format, type, image, context.profile.color_bits);
    add_rectangle_of_any_size(context, std::move(out));
}

void bitmap(Context& context, GLsizei width, GLsizei height, float xorig, float yorig, float xmove,
            float ymove, const HostImage& image) {
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    CurrentState::Raster& raster = context.state.current.raster;
    if (!can_draw(context) || !raster.valid || image.is_refused) return;
    if (is_drawn(context, GL_BITMAP_TOKEN) && image.is_given()) {
        gw::DrawPixels out = rectangle(context, width, height);
        out.raster.x = std::floor(raster.position.x - finite(double(xorig)));
        out.raster.y = std::floor(raster.position.y - finite(double(yorig)));
        out.zoom_x = out.zoom_y = 1;
        for (const std::byte bits : image.bytes)
            out.bits.push_back(std::to_integer<std::uint8_t>(bits));
        add_rectangle_of_any_size(context, std::move(out));
    }
    raster.position.x += finite(double(xmove));
    raster.position.y += finite(double(ymove));
}

void copy_pixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    if (type != GL_COLOR && type != GL_DEPTH && type != GL_STENCIL && type != GL_DEPTH_STENCIL)
        return set_error(context, GL_INVALID_ENUM);
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    if (!can_copy(context, type) || !is_drawn(context, GL_COPY_PIXEL_TOKEN) || width == 0 ||
        height == 0)
        return;
    const Rect rect{x, y, width, height};
    if (type == GL_COLOR) return copy_plane(context, Plane::Color, rect);
    if (type != GL_DEPTH) copy_plane(context, Plane::Stencil, rect);
    if (type == GL_DEPTH) copy_plane(context, Plane::Depth, rect);
    if (type != GL_DEPTH_STENCIL) return;
    const Untested untested(context);
    copy_plane(context, Plane::Depth, rect);
}

}  // namespace execute

}  // namespace gw::gl
