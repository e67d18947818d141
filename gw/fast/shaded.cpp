// Shading the vertices that are used, and those that clipping made.
#include "gw/fast/shaded.h"

namespace gw::fast {

ShadeKey shade_key(const GeometrySet& set, const State& s, const Draw& draw) {
    ShadeKey key{&set, {}, nullptr, s.color_source, {}, s.fog, draw.map.enabled()};
    if (s.color_source == ColorSource::Lighting) {
        key.material = draw.material;
        key.lights = draw.lights;
        key.lighting = s.lighting;
    }
    if (key.textured) {
        key.gen = s.texture.gen;
        key.eta = s.texture.eta;
        key.eye_linear = s.texture.eye_linear;
    }
    return key;
}

namespace {

Rgba to_rgba(const std::array<double, 4>& c) {
    return {std::uint16_t(c[0]), std::uint16_t(c[1]), std::uint16_t(c[2]), std::uint16_t(c[3])};
}

struct Shading {
    ShadedVertices& out;
    bool colors = false, back = false, texcoords = false, fog = false;

    void resize(std::size_t count) {
        if (colors) out.front.resize(count);
        if (back) out.back.resize(count);
        if (texcoords) out.texcoord.resize(count);
        if (fog) out.fog.resize(count);
    }
    void store(std::size_t i, const Vertex& v) {
        if (colors) out.front[i] = to_rgba(v.color);
        if (back) out.back[i] = to_rgba(v.back_color);
        if (texcoords) out.texcoord[i] = v.texcoord;
        if (fog) out.fog[i] = v.fog;
    }
};

/// Vertices of the mesh that some primitive looks at.
std::vector<std::uint8_t> used_vertices(const GeometrySet& set, std::size_t mesh_vertices) {
    std::vector<std::uint8_t> used(mesh_vertices);
    const auto use = [&](std::uint32_t v) {
        if (v < mesh_vertices) used[v] = 1;
    };
    for (const SetupPrimitive& p : set.primitives) {
        for (const std::uint32_t v : p.vertex) use(v);
        use(p.provoking);
    }
    return used;
}

}  // namespace

std::unique_ptr<ShadedVertices> shade_vertices(const GeometrySet& set, const State& s, const Draw& draw,
                                               const Profile& profile) {
    auto out = std::make_unique<ShadedVertices>();
    out->key = shade_key(set, s, draw);
    Shading shading{*out, s.color_source != ColorSource::PolygonId,
                    s.color_source == ColorSource::Lighting && s.lighting.two_side, draw.map.enabled(),
                    s.fog.enable};
    shading.resize(set.vertex_count());

    const VertexProgram program = vertex_program(s, draw, profile);
    const std::uint32_t count = draw.mesh->vertex_count();
    const std::vector<std::uint8_t> used = used_vertices(set, count);
    for (std::uint32_t i = 0; i < count; ++i)
        if (used[i]) shading.store(i, run_vertex(program, i));

    for (const Cut& cut : set.cuts) {
        std::vector<Vertex> corners;
        for (std::uint32_t k = 0; k < cut.sides; ++k) corners.push_back(run_vertex(program, cut.vertex[k]));
        const Clipped clipped = clip(std::move(corners), set.state.viewport);
        for (std::uint32_t k = 0; k < cut.count; ++k) shading.store(cut.first + k, clipped.vertices[k]);
    }
    return out;
}

}  // namespace gw::fast
