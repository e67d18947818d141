#include "gw/stages/vertex.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/fog.h"
#include "gw/stages/lighting.h"
#include "gw/stages/texgen.h"

#include <cmath>

namespace gw {

dmat4 product(const dmat4& a, const dmat4& b) {
    return {transform(a, b[0]), transform(a, b[1]), transform(a, b[2]), transform(a, b[3])};
}

namespace {

/// The inverse transpose of the upper 3x3 up to a positive factor: its cofactors with the sign of
/// the determinant.
dmat3 normal_matrix(const dmat4& m) {
    const dvec3 x(m[0]), y(m[1]), z(m[2]);
    const dvec3 yz = cross3(y, z), zx = cross3(z, x), xy = cross3(x, y);
    const double sign = dot3(x, yz) < 0 ? -1 : 1;
    return {sign * yz, sign * zx, sign * xy};
}

std::array<double, 4> mesh_color(const VertexProgram& p, std::uint32_t index) {
    const auto& colors = p.draw->mesh->data().colors;
    const vec4 c = colors.empty() ? vec4(1) : colors[index];
    const int bits = p.profile->color_bits;
    return {double(quantize(c.x, bits)), double(quantize(c.y, bits)), double(quantize(c.z, bits)),
            double(quantize(c.w, bits))};
}

void light(const VertexProgram& p, const dvec3& p_eye, const dvec3& n_eye, Vertex& out) {
    out.color = lit_color(*p.draw, p.state->lighting, *p.profile, p_eye, n_eye);
    if (p.state->lighting.two_side)
        out.back_color = lit_color(*p.draw, p.state->lighting, *p.profile, p_eye, -n_eye);
}

}  // namespace

VertexProgram vertex_program(const State& state, const Draw& draw, const Profile& profile) {
    VertexProgram p{&state, &draw, &profile};
    p.clip_from_object = product(state.projection, draw.eye_from_object);
    p.normal_eye_from_object = normal_matrix(draw.eye_from_object);
    p.fragment_fog = fog_is_per_fragment(state.fog, profile);
    p.fog_depth = state.fog.enable ? fog_table_depth(state.fog, profile.color_bits) : 1;
    return p;
}

double fog_of(const VertexProgram& p, double z_eye) {
    const double distance = bounded(z_eye < 0 ? -z_eye : 0, largest_coordinate);
    if (p.fragment_fog) return distance / p.fog_depth;
    return double(fog_factor(p.state->fog, distance, p.profile->color_bits));
}

Vertex run_vertex(const VertexProgram& p, std::uint32_t index) {
    const MeshData& mesh = p.draw->mesh->data();
    const State& state = *p.state;
    const dvec4 p_object(dvec3(mesh.positions[index]), 1);
    Vertex out;

    out.clip = transform(p.clip_from_object, p_object);
    const dvec4 p_eye4 = transform(p.draw->eye_from_object, p_object);
    const dvec3 p_eye(p_eye4);
    for (std::size_t i = 0; i < max_clip_planes; ++i)
        if (state.clip_planes[i].enable) out.distance[i] = dot4(state.clip_planes[i].plane, p_eye4);

    const dvec3 n_object = mesh.normals.empty() ? dvec3(0, 0, 1) : dvec3(mesh.normals[index]);
    const dvec3 n_eye = normalized(transform3(p.normal_eye_from_object, n_object));
    if (state.color_source == ColorSource::Vertex) out.color = mesh_color(p, index);
    if (state.color_source == ColorSource::Lighting) light(p, p_eye, n_eye, out);
    if (!(state.color_source == ColorSource::Lighting && state.lighting.two_side))
        out.back_color = out.color;

    const vec2 st = mesh.texcoords.empty() ? vec2(0) : mesh.texcoords[index];
    if (p.draw->map.enabled()) {
        out.texcoord = texture_coordinates(state.texture, st, p_eye4, n_eye);
        for (int i = 0; i < 4; ++i) out.texcoord[i] = bounded(out.texcoord[i], largest_coordinate);
    }
    if (state.fog.enable) out.fog = fog_of(p, p_eye.z);
    return out;
}

}  // namespace gw
