// Colours of vertices and fragments, without texture: lighting, fog, identifiers.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Lighting at the vertices.
Case lighting_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.color_source = ColorSource::Lighting;
        s.state.lighting = any_lighting(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.cull = r.chance(30) ? any_cull(r) : CullState{};
        s.state.depth.test = r.chance(60);
        s.state.blend =
            r.chance(40) ? BlendState{true, BlendFactor::One, BlendFactor::One} : BlendState{};
        s.state.fog = r.chance(20) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        draw(s, any_mesh(r, s.frame, {.normals = r.chance(95), .colors = r.chance(20)}));
        between_draws(s);
    }
    return s.out;
}

// Fog in every mode, at the vertex and per fragment.
Case fog_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.fog = any_fog(r, eye_depth(s.frame));
        s.state.depth.test = r.chance(50);
        s.state.blend =
            r.chance(40) ? BlendState{true, BlendFactor::One, BlendFactor::One} : BlendState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.texture = any_texture_state(r);
        draw(s, any_mesh(r, s.frame, {.texcoords = true, .most = 7}), 20);
        between_draws(s);
    }
    return s.out;
}

// Item buffers: identifiers as colours, exact under any other state.

namespace {

MeshRef with_ids(Random& r, const Mesh& mesh) {
    MeshData data = mesh.data();
    if (r.chance(50))
        for (std::uint32_t i = 0; i < mesh.polygon_count(); ++i)
            data.polygon_ids.push_back(r.chance(50) ? r.bits(8) : r.bits(32));
    return make_mesh(data);
}

}  // namespace

Case identifier_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.color_source = r.chance(90) ? ColorSource::PolygonId : ColorSource::Vertex;
        s.state.depth.test = r.chance(80);
        s.state.polygon_mode = r.chance(85) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.fog = r.chance(30) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        s.state.texture = any_texture_state(r);
        s.state.blend = r.chance(20) ? any_blend(r) : BlendState{};
        s.state.color_mask = r.chance(20) ? any_color_mask(r) : ColorMask{};
        const MeshRef mesh = any_mesh(r, s.frame, {.texcoords = true});
        draw(s, with_ids(r, *mesh), 30);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
