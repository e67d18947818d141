// Runs the vertex stages on the vertices in use, and on those that clipping made.
#include "gw/fast/vertices/vertex_values.h"

#include "gw/command_list.h"
#include "gw/fast/vertices/light.h"
#include "gw/fast/vertices/texgen.h"
#include "gw/stages/clip.h"

#include <algorithm>
#include <cmath>

namespace gw::fast {

bool ColorKey::operator==(const ColorKey& o) const {
    const auto same = [](const LightsRef& a, const LightsRef& b) {
        return a == b || (a && b && *a == *b);
    };
    return set == o.set && color_source == o.color_source && material == o.material &&
           lighting == o.lighting && same(lights, o.lights);
}

ColorKey color_key(const GeometrySet& set, const State& s, const Draw& draw) {
    ColorKey key{&set, {}, nullptr, s.color_source, {}};
    if (s.color_source == ColorSource::Lighting) {
        key.material = draw.material;
        key.lights = draw.lights;
        key.lighting = s.lighting;
    }
    return key;
}

FogKey fog_key(const GeometrySet& set, const State& s) {
    FogKey key{&set, s.fog};
    key.fog.color = vec4(0);
    return key;
}

TexcoordKey texcoord_key(const GeometrySet& set, const State& s) {
    TexcoordKey key{&set, s.texture.gen};
    if (s.texture.gen == TexGen::RefractionMap) key.eta = s.texture.eta;
    if (s.texture.gen == TexGen::EyeLinear) key.eye_linear = s.texture.eye_linear;
    return key;
}

namespace {

Rgba to_rgba(const std::array<double, 4>& c) {
    return {std::uint16_t(c[0]), std::uint16_t(c[1]), std::uint16_t(c[2]), std::uint16_t(c[3])};
}

/// Whether a light's colour times the material's is 0: then its contribution, which is finite, is
/// 0.
bool is_dark(const vec3& light, const vec3& own) {
    for (int c = 0; c < 3; ++c)
        if (!(double(light[c]) * double(own[c]) == 0)) return false;
    return true;
}

/// Whether the light is equally strong everywhere. Finite places are less than 2^300 away, so 0
/// times the square of a distance is 0.
bool is_even(const Light& l, const Draw& draw) {
    if (l.position.w == 0) return true;
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
        largest = std::max(largest, std::abs(double(l.position[i]) / double(l.position.w)));
        for (int k = 0; k < 4; ++k)
            largest = std::max(largest, std::abs(draw.eye_from_object[i][k]));
    }
    return largest < 0x1p150 && l.linear_attenuation == 0 && l.quadratic_attenuation == 0 &&
           l.spot_cos_cutoff <= -1;
}

/// Whether all vertices have one colour, whatever their places and normals.
bool is_uniform(const Draw& draw) {
    const Material& m = draw.material;
    return !draw.lights ||
           std::all_of(draw.lights->begin(), draw.lights->end(), [&](const Light& l) {
               return is_dark(l.Id, m.Kd) && is_dark(l.Is, m.Ks) &&
                      (is_dark(l.Ia, m.Ka) || is_even(l, draw));
           });
}

/// Calls store(index, vertex) for the vertices that clipping made.
template <typename Store>
void for_each_new_vertex(const GeometrySet& set, const VertexProgram& program, const Store& store) {
    for (const ClippedPrimitive& primitive : set.clipped) {
        std::vector<Vertex> corners;
        for (std::uint32_t k = 0; k < primitive.sides; ++k)
            corners.push_back(run_vertex(program, primitive.vertex[k]));
        const Clipped clipped = clip(std::move(corners), set.state.viewport);
        for (std::uint32_t k = 0; k < primitive.count; ++k)
            store(primitive.first + k, clipped.vertices[k]);
    }
}

}  // namespace

void shade_vertices(VertexColors& out, const State& s, const Draw& draw, const Profile& profile) {
    const GeometrySet& set = *out.key.set;
    const bool lit = s.color_source == ColorSource::Lighting, two_side = lit && s.lighting.two_side;
    out.front.resize(set.vertex_count());
    if (two_side) out.back.resize(set.vertex_count());
    State unfogged = s;
    unfogged.fog.enable = false;
    Draw untextured = draw;
    untextured.map = {};
    const VertexProgram program = vertex_program(unfogged, untextured, profile);
    const auto store = [&](std::size_t i, const Vertex& v) {
        out.front[i] = to_rgba(v.color);
        if (two_side) out.back[i] = to_rgba(v.back_color);
    };
    out.uniform = lit && !set.used.empty() && is_uniform(draw);
    if (out.uniform) {
        const Rgba color = to_rgba(run_vertex(program, set.used[0]).color);
        std::fill(out.front.begin(), out.front.end(), color);
        std::fill(out.back.begin(), out.back.end(), color);
        return;
    }
    if (lit) light_vertices(program, two_side ? set.used_front : set.used, false, out.front);
    if (two_side) light_vertices(program, set.used_back, true, out.back);
    for (const std::uint32_t i : set.used)
        if (!lit) store(i, run_vertex(program, i));
    for_each_new_vertex(set, program, store);
}

void fog_vertices(VertexFog& out, const State& s, const Draw& draw, const Profile& profile) {
    const GeometrySet& set = *out.key.set;
    out.value.resize(set.vertex_count());
    State unlit = s;
    unlit.color_source = ColorSource::PolygonId;
    Draw untextured = draw;
    untextured.map = {};
    const VertexProgram program = vertex_program(unlit, untextured, profile);
    for (const std::uint32_t i : set.used) {
        const dvec4 p_object(dvec3(draw.mesh->data().positions[i]), 1);
        out.value[i] = fog_of(program, transform(draw.eye_from_object, p_object).z);
    }
    for_each_new_vertex(set, program,
                        [&](std::size_t i, const Vertex& v) { out.value[i] = v.fog; });
}

void texture_vertices(VertexTexcoords& out, const State& s, const Draw& draw,
                      const Profile& profile) {
    const GeometrySet& set = *out.key.set;
    out.strq.resize(set.vertex_count());
    State unlit = s;
    unlit.color_source = ColorSource::PolygonId;
    unlit.fog.enable = false;
    const VertexProgram program = vertex_program(unlit, draw, profile);
    const auto store = [&](std::size_t i, const Vertex& v) { out.strq[i] = v.texcoord; };
    const std::vector<vec2>& given = draw.mesh->data().texcoords;
    const bool as_given = s.texture.gen == TexGen::None && !given.empty();
    if (as_given)
        for (const std::uint32_t i : set.used) out.strq[i] = {given[i].x, given[i].y, 0, 1};
    else
        generate_texcoords(program, set.used, out.strq);
    for_each_new_vertex(set, program, store);
}

}  // namespace gw::fast
