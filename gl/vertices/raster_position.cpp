// RasterPos. [GL11] 2.12: a vertex that goes through the vertex and clip stages. WindowPos of
// GL_ARB_window_pos and GL_MESA_window_pos give window coordinates instead.
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/draw/machine_state.h"
#include "gl/draw/report.h"
#include "gl/draw/submit.h"

#include "gw/stages/clip.h"
#include "gw/stages/resolve.h"
#include "gw/stages/vertex.h"

#include <cmath>
#include <optional>

namespace gw::gl {

namespace {

/// [GL11] 2.11: inside the view volume, its sides too, which the machine does not clip at. On a side
/// is inside, although the matrices are rounded.
bool is_inside(const Vertex& v, bool zero_to_one) {
    const dvec4& p = v.clip;
    const double most = p.w * (1 + 0x1p-40);
    const double least_z = zero_to_one ? -p.w * 0x1p-40 : -most;
    return std::abs(p.x) <= most && std::abs(p.y) <= most && p.z >= least_z && p.z <= most;
}

/// The nearest multiple of 2^-12 pixel: a position between two pixels stays there, although the
/// matrices are rounded. Else a bitmap may be one pixel off.
double on_grid(double pixels) { return std::floor(pixels * 0x1p12 + 0.5) * 0x1p-12; }

/// The distance of fog. [GL14] 2.13
double fog_distance(const Context& context, double distance) {
    return context.state.fog.coordinate_source == GL_FOG_COORDINATE
               ? double(context.state.current.fog_coordinate)
               : distance;
}

vec3 given_secondary_color(const Context& context) {
    return glm::clamp(context.state.current.secondary_color, 0.0f, 1.0f);
}

double eye_depth(const Context& context, const dvec4& p) {
    const dvec4 eye = transform(context.matrices.modelview.top(), p);
    return eye_point(eye).z;
}

/// The texture coordinates that units 1 to 3 give a point, with textures or without.
FurtherTexcoords further_texcoords(const Context& context, Draw draw) {
    bool changes = false;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        changes |= context.state.texture.units[unit].generates() ||
                   context.matrices.texture[unit].top() != dmat4(1);
    if (!changes) return context.state.current.further_texcoords;
    gw::State state = context.translated.state;
    state.more_textures = further_coordinates(context);
    draw.more_maps =
        std::make_shared<const MoreBindings>(MoreBindings{draw.map, draw.map, draw.map});
    const Vertex vertex = run_vertex(vertex_program(state, draw, context.profile), 0);
    FurtherTexcoords out;
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit)
        for (int i = 0; i < 4; ++i) out[unit - 1][i] = float(finite(vertex.texcoord_of(unit)[i]));
    return out;
}

}  // namespace

namespace execute {

void raster_pos(Context& context, double x, double y, double z, double w) {
    CurrentState::Raster& raster = context.state.current.raster;
    raster.valid = std::isfinite(float(x)) && std::isfinite(float(y)) && std::isfinite(float(z)) &&
                   std::isfinite(float(w));
    if (!raster.valid) return;
    update_machine_state(context);
    // The machine's coordinates of a rectangle are scaled; the raster position's count texels.
    std::optional<gw::State> in_texels;
    if (coordinate_scale(context, 0) != dvec2(1)) {
        in_texels = context.translated.state;
        in_texels->texture.matrix = context.matrices.texture[0].top();
    }
    const gw::State& state = in_texels ? *in_texels : *context.translated.state;
    const AssembledVertex values = current_vertex(context.state.current);
    MeshData point{.positions = {vec3(x, y, z)}, .w = {float(w)}};
    point.primitive = Primitive::Points;
    const Draw draw = with_texture_coordinates(
        make_draw(context, make_mesh(std::move(point)), values,
                  context.state.current.further_texcoords, face_materials(context)));
    const VertexProgram program = vertex_program(state, draw, context.profile);
    const Vertex vertex = run_vertex(program, 0);
    const ViewportTransform viewport =
        resolve(state, context.profile, max_window_size, max_window_size).viewport;
    raster.valid =
        is_inside(vertex, viewport.zero_to_one) && !clip({vertex}, viewport).vertices.empty();
    if (!raster.valid) return;
    const double cw = vertex.clip.w;
    raster.position = {on_grid((vertex.clip.x / cw) * viewport.half_width + viewport.center_x),
                       on_grid((vertex.clip.y / cw) * viewport.half_height + viewport.center_y),
                       window_depth(vertex.clip.z / cw, state), cw};
    raster.distance = fog_distance(context, finite(std::abs(eye_depth(context, {x, y, z, w}))));
    const auto largest = float((1u << context.profile.color_bits) - 1);
    for (int i = 0; i < 4; ++i) {
        raster.color[i] = float(vertex.color[std::size_t(i)]) / largest;
        raster.texcoord[i] = float(finite(vertex.texcoord[i]));
    }
    raster.secondary_color = given_secondary_color(context);
    if (context.state.lighting.enable)
        for (int i = 0; i < 3; ++i)
            raster.secondary_color[i] = float(vertex.secondary[std::size_t(i)]) / largest;
    raster.further_texcoords = further_texcoords(context, draw);
    raster.index = context.state.current.index;
    report_depth(context, raster.position.z);
}

/// No transform, no clipping, no lighting: the current values as they are.
void window_pos(Context& context, double x, double y, double z, double w) {
    CurrentState::Raster& raster = context.state.current.raster;
    raster.valid = std::isfinite(float(x)) && std::isfinite(float(y)) && std::isfinite(float(z)) &&
                   std::isfinite(float(w));
    if (!raster.valid) return;
    const double n = context.state.viewport.near_value, f = context.state.viewport.far_value;
    raster.position = {x, y, n + clamped(z, 0.0, 1.0) * (f - n), w};
    raster.distance = fog_distance(context, 0);
    raster.color = glm::clamp(context.state.current.color, 0.0f, 1.0f);
    raster.secondary_color = given_secondary_color(context);
    raster.texcoord = context.state.current.texcoord;
    raster.further_texcoords = context.state.current.further_texcoords;
    raster.index = context.state.current.index;
    report_depth(context, raster.position.z);
}

}  // namespace execute

}  // namespace gw::gl
