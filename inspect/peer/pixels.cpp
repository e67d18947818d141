#include "inspect/peer/commands.h"

#include "gw/error.h"
#include "inspect/peer/gl.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gw::peer {
namespace {

/// Puts the state back at the end of the scope.
struct SavedState {
    SavedState() { gl().PushAttrib(GL_ALL_ATTRIB_BITS); }
    ~SavedState() { gl().PopAttrib(); }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;
};

/// Nothing but the plane's mask and the scissor between a value and its plane: OpenGL runs
/// rectangles through every test.
void write_only(Plane plane, const DepthState& depth) {
    gl().Disable(GL_ALPHA_TEST);
    gl().Disable(GL_STENCIL_TEST);
    gl().Disable(GL_BLEND);
    enable(GL_DEPTH_TEST, plane == Plane::Depth && depth.mask);
    gl().DepthFunc(GL_ALWAYS);
    gl().DepthRange(0, 1);
    if (plane != Plane::Color) gl().ColorMask(false, false, false, false);
}

std::vector<GLubyte> bytes(const Rgba* first, std::size_t count) {
    std::vector<GLubyte> result;
    for (const Rgba* c = first; c != first + count; ++c)
        for (const std::uint16_t channel : *c) result.push_back(static_cast<GLubyte>(channel));
    return result;
}

/// The raster position at window coordinates.
void set_window_pos(double x, double y, double z) {
    required(gl().WindowPos3d, "glWindowPos", "pixels")(x, y, z);
}

/// A depth of 24 bits as OpenGL's window z.
double window_z(std::uint32_t depth) { return depth / 16777215.0; }

/// ... and as a 32-bit fraction, the 24 bits repeated.
std::uint32_t fraction32(std::uint32_t depth) { return depth << 8 | depth >> 16; }

void draw_colors(int x, int y, int width, int height, std::uint32_t depth,
                 const std::vector<GLubyte>& rgba) {
    gl().DepthRange(0, 1);
    set_window_pos(x, y, window_z(depth));
    gl().DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
}

void draw_depths(const WritePixels& c) {
    std::vector<std::uint32_t> wide(c.values.size());
    std::transform(c.values.begin(), c.values.end(), wide.begin(), fraction32);
    set_window_pos(c.rect.x, c.rect.y, 0);
    gl().DrawPixels(c.rect.width, c.rect.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, wide.data());
}

void draw_stencil(const WritePixels& c) {
    const std::vector<GLubyte> values(c.values.begin(), c.values.end());
    set_window_pos(c.rect.x, c.rect.y, 0);
    gl().DrawPixels(c.rect.width, c.rect.height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
}

GLenum copied(Plane plane) {
    return plane == Plane::Color ? GL_COLOR : plane == Plane::Depth ? GL_DEPTH : GL_STENCIL;
}

GLbitfield buffers(PlaneMask planes) {
    const auto bit = [&](Plane plane, GLbitfield buffer) {
        return planes & mask_of(plane) ? buffer : 0;
    };
    return bit(Plane::Color, GL_COLOR_BUFFER_BIT) | bit(Plane::Depth, GL_DEPTH_BUFFER_BIT) |
           bit(Plane::Stencil, GL_STENCIL_BUFFER_BIT) | bit(Plane::Accum, GL_ACCUM_BUFFER_BIT);
}

}  // namespace

void clear(const Clear& c, float accum_scale) {
    gl().ClearColor(c.color.r, c.color.g, c.color.b, c.color.a);
    gl().ClearDepth(c.depth);
    gl().ClearStencil(c.stencil);
    const vec4 accum = glm::clamp(c.accum, -1.0f, 1.0f) / accum_scale;
    gl().ClearAccum(accum.r, accum.g, accum.b, accum.a);
    gl().Clear(buffers(c.planes));
}

void write(const WriteSpans& command) {
    const SavedState saved;
    for (const Span& s : command.spans) {
        if (s.length <= 0) continue;
        const auto length = std::size_t(s.length);
        const std::vector<Rgba> run(s.flat ? length : 0, command.colors[s.first]);
        draw_colors(s.x, s.y, s.length, 1, command.depth,
                    bytes(s.flat ? run.data() : &command.colors[s.first], length));
    }
}

void write(const WritePixels& c, const DepthState& depth) {
    const SavedState saved;
    if (c.plane == Plane::Color) {
        draw_colors(c.rect.x, c.rect.y, c.rect.width, c.rect.height, c.depth,
                    bytes(c.colors.data(), c.colors.size()));
        return;
    }
    write_only(c.plane, depth);
    c.plane == Plane::Depth ? draw_depths(c) : draw_stencil(c);
}

namespace {

void check_rectangle(const DrawPixels& c) {
    const bool bitmap = !c.bits.empty();
    if (!c.colors.empty() && !c.depths.empty())
        throw Error("colours with depths; OpenGL has rectangles of either");
    if (bitmap && (!c.colors.empty() || !c.depths.empty() || !c.stencils.empty() || c.source))
        throw Error("bits with values; OpenGL has bitmaps of one colour");
    if (bitmap && (c.zoom_x != 1 || c.zoom_y != 1))
        throw Error("bits with a zoom; OpenGL does not zoom bitmaps");
}

/// glRasterPos' values, by way of a window position.
void set_raster_position(const RasterPosition& r, const State& state,
                         const TextureTargets& targets) {
    const std::vector<GLubyte> color = bytes(&r.color, 1), secondary = bytes(&r.secondary_color, 1);
    gl().Color4ubv(color.data());
    if (sums_colors(state)) {
        required(gl().SecondaryColor3ubv, "glSecondaryColor",
                 "a secondary colour")(secondary.data());
        enable(GL_COLOR_SUM, true);
    }
    gl().TexCoord4d(r.texcoord.x, r.texcoord.y, r.texcoord.z, r.texcoord.w);
    for (std::size_t unit = 1; unit < targets.size(); ++unit) {
        if (targets[unit] == 0) continue;
        const vec4& of = r.more_texcoords[unit - 1];
        gl().MultiTexCoord4d(GL_TEXTURE0 + static_cast<GLenum>(unit), of.x, of.y, of.z, of.w);
    }
    if (gl().FogCoordd)
        gl().FogCoordd(state.fog.source == FogSource::Coordinate ? r.fog_coordinate : r.distance);
    gl().DepthRange(0, 1);
    set_window_pos(r.x, r.y, window_z(r.depth));
}

void draw_values(const DrawPixels& c) {
    const auto send = [&](GLenum format, GLenum type, const void* values) {
        gl().DrawPixels(c.width, c.height, format, type, values);
    };
    if (c.source)
        gl().CopyPixels(c.source->x, c.source->y, c.width, c.height, copied(c.source->plane));
    else if (!c.stencils.empty())
        send(GL_STENCIL_INDEX, GL_UNSIGNED_INT, c.stencils.data());
    else if (!c.colors.empty())
        send(GL_RGBA, GL_UNSIGNED_BYTE, bytes(c.colors.data(), c.colors.size()).data());
    else if (!c.bits.empty())
        gl().Bitmap(c.width, c.height, 0, 0, 0, 0, c.bits.data());
    else if (c.depths.empty())
        send(GL_RGBA, GL_UNSIGNED_BYTE,
             bytes(std::vector<Rgba>(c.area(), c.raster.color).data(), c.area()).data());
    else {
        std::vector<std::uint32_t> wide(c.depths.size());
        std::transform(c.depths.begin(), c.depths.end(), wide.begin(), fraction32);
        send(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, wide.data());
    }
}

}  // namespace

void draw(const DrawPixels& c, const State& state, const TextureTargets& targets) {
    check_rectangle(c);
    if (state.fog.enable && !gl().FogCoordd) refuse("glFogCoord", "fog of drawn pixels");
    const SavedState saved;
    apply(state.fog, true, state.fog.enable);
    enable(targets, true);
    set_raster_position(c.raster, state, targets);
    gl().PixelZoom(float(c.zoom_x), float(c.zoom_y));
    draw_values(c);
}

void copy(const Copy& c, const DepthState& depth) {
    const SavedState saved;
    write_only(c.plane, depth);
    set_window_pos(c.x, c.y, 0);
    gl().CopyPixels(c.source.x, c.source.y, c.source.width, c.source.height, copied(c.plane));
}

void accumulate(const Accumulate& command, float accum_scale) {
    switch (command.op) {
        case AccumOp::Accum:
        case AccumOp::Load:
        case AccumOp::Add: gl().Accum(token(command.op), command.value / accum_scale); break;
        case AccumOp::Mult: gl().Accum(GL_MULT, command.value); break;
        case AccumOp::Return: gl().Accum(GL_RETURN, command.value * accum_scale); break;
    }
}

std::vector<std::uint8_t> read_colors(int width, int height) {
    std::vector<std::uint8_t> rgba(4 * std::size_t(width) * std::size_t(height));
    gl().ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

void replace_colors(int width, int height, const std::vector<std::uint8_t>& rgba) {
    const SavedState saved;
    write_only(Plane::Color, {.mask = false});
    for (const GLenum off : {GL_SCISSOR_TEST, GL_COLOR_LOGIC_OP}) gl().Disable(off);
    gl().ColorMask(true, true, true, true);
    gl().DrawBuffer(gl().color_buffer);
    draw_colors(0, 0, width, height, 0, rgba);
}

Planes read_planes(int width, int height) {
    Planes planes(width, height);
    const std::vector<std::uint8_t> rgba = read_colors(width, height);
    for (std::size_t i = 0; i < rgba.size(); ++i) planes.color[i / 4][i % 4] = rgba[i];
    gl().ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, planes.depth.data());
    for (std::uint32_t& depth : planes.depth) depth >>= 8;
    gl().ReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, planes.stencil.data());
    return planes;
}

}  // namespace gw::peer
