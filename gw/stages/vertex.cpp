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

double determinant(const dmat4& m) { return dot3(dvec3(m[0]), cross3(dvec3(m[1]), dvec3(m[2]))); }

}  // namespace

bool same_current(const Draw& a, const Draw& b) {
    if (a.current == b.current) return true;
    const CurrentValues initial;
    return (a.current ? *a.current : initial) == (b.current ? *b.current : initial);
}

vec4 given_color(const Draw& draw, std::uint32_t index) {
    const auto& colors = draw.mesh->data().colors;
    if (!colors.empty()) return colors[index];
    return draw.current ? draw.current->color : CurrentValues{}.color;
}

dvec3 given_normal(const Draw& draw, std::uint32_t index) {
    const auto& normals = draw.mesh->data().normals;
    if (!normals.empty()) return normals[index];
    return draw.current ? draw.current->normal : CurrentValues{}.normal;
}

dvec4 given_texcoord(const Draw& draw, std::uint32_t index, std::size_t unit) {
    const MeshData& mesh = draw.mesh->data();
    if (unit > 0) {
        const UnitTexcoords& own = mesh.more_texcoords[unit - 1];
        if (own.st.empty())
            return (draw.current ? draw.current->more_texcoords : initial_texcoords)[unit - 1];
        const vec2 st = own.st[index], rq = own.rq.empty() ? vec2(0, 1) : own.rq[index];
        return {st.x, st.y, rq.x, rq.y};
    }
    if (mesh.texcoords.empty()) return draw.current ? draw.current->texcoord : vec4(0, 0, 0, 1);
    const vec2 st = mesh.texcoords[index];
    const vec2 rq = mesh.texcoords_rq.empty() ? vec2(0, 1) : mesh.texcoords_rq[index];
    return {st.x, st.y, rq.x, rq.y};
}

vec3 given_secondary_color(const Draw& draw, std::uint32_t index) {
    const auto& colors = draw.mesh->data().secondary_colors;
    if (!colors.empty()) return colors[index];
    return draw.current ? draw.current->secondary_color : CurrentValues{}.secondary_color;
}

double given_fog_coordinate(const Draw& draw, std::uint32_t index) {
    const auto& coordinates = draw.mesh->data().fog_coordinates;
    if (!coordinates.empty()) return coordinates[index];
    return draw.current ? draw.current->fog_coordinate : CurrentValues{}.fog_coordinate;
}

void follow_color(ColorMaterial mode, const vec4& color, Material& m) {
    const vec3 rgb(color);
    switch (mode) {
        case ColorMaterial::Emission: m.Ke = rgb; return;
        case ColorMaterial::Ambient: m.Ka = rgb; return;
        case ColorMaterial::Specular: m.Ks = rgb; return;
        case ColorMaterial::AmbientAndDiffuse: m.Ka = rgb; break;
        case ColorMaterial::Diffuse: break;
    }
    m.Kd = rgb;
    m.alpha = color.w;
}

Material material_of(const VertexProgram& p, std::uint32_t index, Face side) {
    const Draw& draw = *p.draw;
    const MeshData& mesh = draw.mesh->data();
    const bool front = side == Face::Front;
    Material m = front || !draw.back_material ? draw.material : *draw.back_material;
    if (!mesh.material_indices.empty()) {
        const FaceMaterials& own = mesh.materials[mesh.material_indices[index]];
        m = front ? own.front : own.back;
    }
    const ColorMaterialState& follows = p.state->lighting.color_material;
    if (follows_color(follows, side)) follow_color(follows.mode, given_color(draw, index), m);
    return m;
}

namespace {

std::array<double, 4> quantized_color(const vec4& c, int bits) {
    return {double(quantize(c.x, bits)), double(quantize(c.y, bits)), double(quantize(c.z, bits)),
            double(quantize(c.w, bits))};
}

bool is_affine(const dmat4& m) {
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

bool has_one_material(const ColorMaterialState& follows, const MeshData& mesh) {
    return mesh.material_indices.empty() && (!follows.enable || mesh.colors.empty());
}

dvec3 eye_normal(const VertexProgram& p, const dvec3& n_object) {
    const dvec3 n = transform3(p.normal_eye_from_object, n_object);
    if (p.state->normalize) return normalized(n);
    const auto scaled = [&](double v) { return bounded(v * p.normal_scale, largest_coordinate); };
    return {scaled(n.x), scaled(n.y), scaled(n.z)};
}

void light(const VertexProgram& p, std::uint32_t index, const dvec3& p_eye, const dvec3& n_eye,
           Vertex& out) {
    const auto light_side = [&](Face side, const dvec3& n, auto& color, auto& secondary) {
        const LitColors lit = lit_colors(material_of(p, index, side), p.draw->lights,
                                         p.state->lighting, *p.profile, p_eye, n);
        color = lit.color;
        secondary = lit.secondary;
    };
    light_side(Face::Front, n_eye, out.color, out.secondary);
    if (p.state->lighting.two_side)
        light_side(Face::Back, -n_eye, out.back_color, out.back_secondary);
}

}  // namespace

void change_draw(VertexProgram& p, const Draw& draw) {
    const MeshData& mesh = draw.mesh->data();
    p.draw = &draw;
    p.is_affine = mesh.w.empty() && is_affine(draw.eye_from_object);
    p.has_one_material = has_one_material(p.state->lighting.color_material, mesh);
}

VertexProgram vertex_program(const State& state, const Draw& draw, const Profile& profile) {
    VertexProgram p{&state, &draw, &profile};
    p.clip_from_object = product(state.projection, draw.eye_from_object);
    p.normal_eye_from_object = normal_matrix(draw.eye_from_object);
    const double size = std::abs(determinant(draw.eye_from_object));
    p.normal_scale = size > 0 ? 1 / size : 0;
    change_draw(p, draw);
    p.fragment_fog = fog_is_per_fragment(state.fog, profile);
    p.fog_depth = state.fog.enable ? fog_unit(state.fog, profile.color_bits) : 1;
    return p;
}

double fog_of(const VertexProgram& p, std::uint32_t index, double z_eye) {
    const bool given = p.state->fog.source == FogSource::Coordinate;
    const double z =
        bounded(given ? given_fog_coordinate(*p.draw, index) : -z_eye, largest_coordinate);
    if (p.fragment_fog) return z / p.fog_depth;
    return double(fog_factor(p.state->fog, given || z > 0 ? z : 0, p.profile->color_bits));
}

Vertex run_vertex(const VertexProgram& p, std::uint32_t index) {
    const State& state = *p.state;
    const Draw& draw = *p.draw;
    const dvec4 p_object = object_position(draw.mesh->data(), index);
    Vertex out;

    out.clip = transform(p.clip_from_object, p_object);
    const dvec4 p_eye4 = transform(draw.eye_from_object, p_object);
    const dvec3 p_eye = eye_point(p_eye4);
    for (std::size_t i = 0; i < max_clip_planes; ++i)
        if (state.clip_planes[i].enable) out.distance[i] = dot4(state.clip_planes[i].plane, p_eye4);

    const dvec3 n_eye = eye_normal(p, given_normal(draw, index));
    if (state.color_source == ColorSource::Vertex) {
        out.color = quantized_color(given_color(draw, index), p.profile->color_bits);
        out.secondary =
            quantized_color(vec4(given_secondary_color(draw, index), 0), p.profile->color_bits);
    }
    if (state.color_source == ColorSource::Lighting) light(p, index, p_eye, n_eye, out);
    if (!(state.color_source == ColorSource::Lighting && state.lighting.two_side)) {
        out.back_color = out.color;
        out.back_secondary = out.secondary;
    }

    const auto coordinates = [&](std::size_t unit) {
        dvec4 at = texture_coordinates(texture_of(state, unit), {given_texcoord(draw, index, unit),
                                                                 p_object, p_eye4, p_eye, n_eye});
        if (is_one_dimensional(draw, unit)) at.y = 0;
        for (int i = 0; i < 4; ++i) at[i] = bounded(at[i], largest_coordinate);
        return at;
    };
    if (draw.map.enabled()) out.texcoord = coordinates(0);
    if (draw.more_maps)
        for (std::size_t unit = 1; unit < max_texture_units; ++unit)
            if (map_of(draw, unit).enabled()) out.more_texcoords[unit - 1] = coordinates(unit);
    if (state.fog.enable) out.fog = fog_of(p, index, p_eye.z);
    return out;
}

}  // namespace gw
