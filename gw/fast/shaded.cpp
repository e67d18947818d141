// Running the vertex stages on the vertices that are used, and on those that clipping made.
#include "gw/fast/shaded.h"

namespace gw::fast {

ColorKey color_key(const GeometrySet& set, const State& s, const Draw& draw) {
    ColorKey key{&set, {}, nullptr, s.color_source, {}, s.fog};
    if (s.color_source == ColorSource::Lighting) {
        key.material = draw.material;
        key.lights = draw.lights;
        key.lighting = s.lighting;
    }
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

/// Calls store(index, vertex) for every used vertex of the set.
template <typename Store>
void for_each_vertex(const GeometrySet& set, const State& state, const Draw& draw, const Profile& profile,
                     const Store& store) {
    const VertexProgram program = vertex_program(state, draw, profile);
    for (std::uint32_t i = 0; i < draw.mesh->vertex_count(); ++i)
        if (set.used[i]) store(i, run_vertex(program, i));
    for (const Cut& cut : set.cuts) {
        std::vector<Vertex> corners;
        for (std::uint32_t k = 0; k < cut.sides; ++k) corners.push_back(run_vertex(program, cut.vertex[k]));
        const Clipped clipped = clip(std::move(corners), set.state.viewport);
        for (std::uint32_t k = 0; k < cut.count; ++k) store(cut.first + k, clipped.vertices[k]);
    }
}

}  // namespace

std::unique_ptr<VertexColors> shade_vertices(const GeometrySet& set, const State& s, const Draw& draw,
                                             const Profile& profile) {
    auto out = std::make_unique<VertexColors>();
    out->key = color_key(set, s, draw);
    const bool two_side = s.color_source == ColorSource::Lighting && s.lighting.two_side;
    out->front.resize(set.vertex_count());
    if (two_side) out->back.resize(set.vertex_count());
    if (s.fog.enable) out->fog.resize(set.vertex_count());
    Draw untextured = draw;
    untextured.map = {};
    for_each_vertex(set, s, untextured, profile, [&](std::size_t i, const Vertex& v) {
        out->front[i] = to_rgba(v.color);
        if (two_side) out->back[i] = to_rgba(v.back_color);
        if (s.fog.enable) out->fog[i] = v.fog;
    });
    return out;
}

std::unique_ptr<VertexTexcoords> texture_vertices(const GeometrySet& set, const State& s, const Draw& draw,
                                                  const Profile& profile) {
    auto out = std::make_unique<VertexTexcoords>();
    out->key = texcoord_key(set, s);
    out->strq.resize(set.vertex_count());
    State unlit = s;
    unlit.color_source = ColorSource::PolygonId;
    unlit.fog.enable = false;
    for_each_vertex(set, unlit, draw, profile,
                    [&](std::size_t i, const Vertex& v) { out->strq[i] = v.texcoord; });
    return out;
}

}  // namespace gw::fast
