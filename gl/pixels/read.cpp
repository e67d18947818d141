// ReadPixels. [GL11] 4.3.2
#include "gl/pixels/read.h"
#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"
#include "gl/draw/targets.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/memory.h"
#include "gl/pixels/packed.h"
#include "gl/pixels/transfer.h"
#include "gw/stages/resolve.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// Places what was read in a rectangle that may stick out of the drawable; pixels outside are 0.
template <class T, class Value>
void place(std::vector<T>& out, const Rect& rect, const Rect& inside, Value value) {
    for (int y = inside.y; y < inside.y + inside.height; ++y)
        for (int x = inside.x; x < inside.x + inside.width; ++x)
            out[rect.index(x, y)] = value(inside.index(x, y));
}

/// Sends the read buffer, or the surface, to the drawable that is read.
void select_plane(Context& context, Plane plane) {
    if (context.framebuffers.read)
        return context.shared->off_screen->use(read_surface(context, plane));
    if (plane != Plane::Color) return;
    if (context.read_drawable == context.drawable) {
        submit_state(context);
        return;
    }
    update_machine_state(context);
    gw::State state = context.translated.state;
    const GLenum mode = context.state.pixel.read_buffer;
    const bool is_back = mode == GL_BACK || mode == GL_BACK_LEFT;
    state.read_buffer = is_back && context.read_drawable->has_back_plane() ? gw::ReadBuffer::Back
                                                                           : gw::ReadBuffer::Front;
    context.read_drawable->set_state(state);
}

/// The colours of a rectangle, 8 bits a channel; 0 outside the drawable.
std::vector<std::uint32_t> read_words(Context& context, const Rect& rect, Cause cause) {
    std::vector<std::uint32_t> out(rect.area(), 0);
    const Rect inside = part_inside(context, rect);
    if (inside.area() == 0) return out;
    const TargetLock lock = lock_target(context, *context.read_drawable);
    select_plane(context, Plane::Color);
    if (inside == rect) {
        context.read_drawable->read_packed(rect, cause, out);
        return out;
    }
    std::vector<std::uint32_t> read(inside.area());
    context.read_drawable->read_packed(inside, cause, read);
    place(out, rect, inside, [&](std::size_t i) { return read[i]; });
    return out;
}

bool has_bytes(const Context& context) { return context.read_drawable->profile().color_bits == 8; }

double largest(int bits) { return double((std::uint64_t{1} << bits) - 1); }

/// Whether bytes of a format are bytes of the plane, each after transfer.
bool is_read_as_bytes(const Context& context, GLenum format, GLenum type) {
    return type == GL_UNSIGNED_BYTE && is_texel_format(format) && has_bytes(context) &&
           format != GL_LUMINANCE && format != GL_LUMINANCE_ALPHA;
}

/// Reads such bytes, row after row.
void read_bytes(Context& context, const Rect& rect, GLenum format, std::byte* out) {
    const bool is_words = (format == GL_RGBA || format == GL_BGRA) &&
                          reinterpret_cast<std::uintptr_t>(out) % alignof(std::uint32_t) == 0;
    if (!is_words || part_inside(context, rect) != rect)
        return pack_bytes(context, read_words(context, rect, Cause::Read), format, out);
    const std::span words(reinterpret_cast<std::uint32_t*>(out), rect.area());
    const TargetLock lock = lock_target(context, *context.read_drawable);
    select_plane(context, Plane::Color);
    context.read_drawable->read_packed(rect, Cause::Read, words);
    pack_bytes(context, words, format, out);
}

/// The rows of a rectangle of colours for memory.
std::vector<std::byte> packed_rows(Context& context, const Rect& rect, GLenum given_format,
                                   GLenum given_type) {
    const auto [format, type] = as_bytes(given_format, given_type);
    if (is_read_as_bytes(context, format, type)) {
        std::vector<std::byte> rows(rect.area() * std::size_t(component_count(format)));
        read_bytes(context, rect, format, rows.data());
        return rows;
    }
    std::vector<vec4> colors = read_colors(context, rect, Cause::Read);
    if (!leaves_colors(context.state.pixel))
        for (vec4& color : colors) color = transferred_color(context, color);
    return packed_colors(colors, format, type);
}

/// Rows of depths and stencil values for memory.
std::vector<std::byte> packed_pairs(Context& context, const Rect& rect) {
    DepthsAndStencils out;
    for (const double depth : read_values(context, Plane::Depth, rect, Cause::Read))
        out.depths.push_back(transferred_depth(context, depth));
    const std::vector<double> stencils = read_values(context, Plane::Stencil, rect, Cause::Read);
    out.stencils.assign(stencils.begin(), stencils.end());
    if (!leaves_stencils(context.state.pixel))
        for (GLuint& stencil : out.stencils)
            stencil = transferred_stencil(context, double(stencil));
    return packed_depths_and_stencils(out);
}

/// Whether what is read has the planes of a format.
bool has_planes(Context& context, GLenum format) {
    switch (format) {
        case GL_DEPTH_COMPONENT: return can_read(context, Plane::Depth);
        case GL_STENCIL_INDEX: return can_read(context, Plane::Stencil);
        case GL_DEPTH_STENCIL:
            return can_read(context, Plane::Depth) && can_read(context, Plane::Stencil);
    }
    return can_read(context, Plane::Color);
}

}  // namespace

Rect part_inside(const Context& context, const Rect& r) {
    const auto clip = [](std::int64_t low, std::int64_t size, int limit) {
        const std::int64_t begin = std::clamp<std::int64_t>(low, 0, limit);
        return std::pair(int(begin), int(std::clamp<std::int64_t>(low + size, 0, limit) - begin));
    };
    const FramebufferSize size = read_size(context);
    const auto [x, width] = clip(r.x, r.width, size.width);
    const auto [y, height] = clip(r.y, r.height, size.height);
    return {x, y, width, height};
}

Readback read_raw(Context& context, Plane plane, const Rect& rect) {
    const TargetLock lock = lock_target(context, *context.read_drawable);
    select_plane(context, plane);
    return context.read_drawable->read(plane, rect, Cause::Copy);
}

std::vector<vec4> read_colors(Context& context, const Rect& rect, Cause cause) {
    std::vector<vec4> out(rect.area(), vec4(0));
    const Rect inside = part_inside(context, rect);
    if (inside.area() == 0) return out;
    const TargetLock lock = lock_target(context, *context.read_drawable);
    select_plane(context, Plane::Color);
    const Readback read = context.read_drawable->read(Plane::Color, inside, cause);
    const auto scale = float(largest(context.read_drawable->profile().color_bits));
    place(out, rect, inside, [&](std::size_t i) {
        const Rgba& p = read.color[i];
        return vec4(p[0], p[1], p[2], p[3]) / scale;
    });
    return out;
}

std::vector<Rgba> read_rgba(Context& context, const Rect& rect, Cause cause, int bits) {
    if (has_bytes(context))
        return transferred_rgba(context, read_words(context, rect, cause), bits);
    std::vector<Rgba> out;
    for (const vec4& color : read_colors(context, rect, cause))
        out.push_back(quantize_color(transferred_color(context, color), bits));
    return out;
}

std::vector<double> read_values(Context& context, Plane plane, const Rect& rect, Cause cause) {
    const Rect inside = part_inside(context, rect);
    if (inside.area() == 0) return std::vector(rect.area(), 0.0);
    std::vector<std::uint32_t> read(inside.area());
    const TargetLock lock = lock_target(context, *context.read_drawable);
    select_plane(context, plane);
    context.read_drawable->read_values(plane, inside, cause, read);
    const double scale = plane == Plane::Depth ? largest(read_depth_bits(context)) : 1.0;
    std::vector<double> values(read.size());
    for (std::size_t i = 0; i < read.size(); ++i) values[i] = double(read[i]) / scale;
    if (inside == rect) return values;
    std::vector<double> out(rect.area(), 0.0);
    place(out, rect, inside, [&](std::size_t i) { return values[i]; });
    return out;
}

namespace execute {

void read_pixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, GLvoid* pixels) {
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    if (const GLenum error = format_error(format, type)) return set_error(context, error);
    if (format == GL_COLOR_INDEX) return set_error(context, GL_INVALID_OPERATION);
    if (!has_planes(context, format)) return;
    if (context.read_drawable == nullptr || width == 0 || height == 0) return;
    const PixelStore& store = context.client.pack;
    const auto lock =
        store.buffer ? context.shared->exclusive() : std::unique_lock<std::recursive_mutex>{};
    pixels = image_memory(context, store, width, height, format, type, pixels);
    if (pixels == nullptr) return;
    flush_mesh(context);
    const Rect rect{x, y, width, height};
    if (const auto [byte_format, byte_type] = as_bytes(format, type);
        is_read_as_bytes(context, byte_format, byte_type))
        if (const auto at = rows_in_memory(context.client.pack, width, format, type))
            return read_bytes(context, rect, byte_format, static_cast<std::byte*>(pixels) + *at);
    std::vector<std::byte> rows;
    if (format == GL_DEPTH_STENCIL) {
        rows = packed_pairs(context, rect);
    } else if (format == GL_STENCIL_INDEX || format == GL_DEPTH_COMPONENT) {
        const bool is_depth = format == GL_DEPTH_COMPONENT;
        std::vector<double> values =
            read_values(context, is_depth ? Plane::Depth : Plane::Stencil, rect, Cause::Read);
        if (is_depth)
            for (double& v : values) v = transferred_depth(context, v);
        else if (!leaves_stencils(context.state.pixel))
            for (double& v : values) v = double(transferred_stencil(context, v));
        rows = packed_values(values, width, format, type);
    } else {
        rows = packed_rows(context, rect, format, type);
    }
    copy_to_memory(pixels, context.client.pack, width, height, format, type, rows);
}

}  // namespace execute

}  // namespace gw::gl
