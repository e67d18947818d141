// Polygons as outlines and corners: edge flags, facing, clipping.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "conformance/suites.h"

namespace gw::fuzz {

Case polygon_mode_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.polygon_mode = r.chance(85) ? r.any(PolygonMode::Line) : PolygonMode::Fill;
        s.state.line_width = r.chance(60) ? 1 : r.between(1, 6);
        s.state.point_size = r.chance(60) ? 1 : r.between(1, 6);
        s.state.cull = any_cull(r);
        s.state.depth = any_depth(r);
        s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
        s.state.stencil = r.chance(20) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.clip_planes = {};
        if (r.chance(20)) any_clip_planes(r, s.frame, s.state);
        if (r.chance(30))
            s.state.color_source = r.pick({ColorSource::Vertex, ColorSource::Lighting});
        s.state.lighting = any_lighting(r);
        draw(s, any_triangles(r, s.frame, {.normals = true}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::fuzz
