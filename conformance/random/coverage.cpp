// Which pixels a primitive covers: shapes, clipping, bounds, jitter.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <cmath>

namespace gw::conformance {

// Coverage: the pixels of a triangle and their depths and colours.
Case raster_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.cull = any_cull(r);
        s.state.depth = {.test = r.chance(50)};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        // Additive, so that a pixel drawn twice is visible.
        s.state.blend = {.enable = r.chance(70), .src = BlendFactor::One, .dst = BlendFactor::One};
        draw(s, any_triangles(r, s.frame, {}));
        between_draws(s);
    }
    return s.out;
}

// Clipping: planes through the picture, vertices behind the eye, w of any size.

namespace {

/// A matrix that need not be a projection.
dmat4 any_projection(Random& r) {
    dmat4 p(0);
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 4; ++i) p[c][i] = r.chance(40) ? r.between(-2, 2) : r.real(-2, 2);
    if (r.chance(20)) p *= std::ldexp(1.0, r.between(-900, 900));
    return p;
}

/// Rotates and scales eye space, seldom so far that squares overflow.
dmat4 any_affine(Random& r) {
    dmat4 m(1);
    const double size = r.chance(10) ? std::ldexp(1.0, r.between(-600, 900)) : 1;
    for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 3; ++i)
            m[c][i] = size * (r.chance(30) ? r.between(-2, 2) : r.real(-2, 2));
    return m;
}

}  // namespace

Case clip_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 5);
    for (int i = 0; i < draws; ++i) {
        s.state.clip_planes = {};
        if (r.chance(50)) any_clip_planes(r, s.frame, s.state);
        s.state.cull = any_cull(r);
        s.state.depth = {.test = r.chance(60)};
        s.state.polygon_mode = r.chance(85) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.projection = s.frame.projection;
        Frame frame = s.frame;
        if (r.chance(25)) {
            s.state.projection = any_projection(r);
            s.frame.eye_from_object = any_affine(r);
        }
        if (r.chance(20)) s.state.fog = any_fog(r, eye_depth(frame));
        if (r.chance(20))
            s.state.color_source = r.pick({ColorSource::Vertex, ColorSource::Lighting});
        s.state.texture.gen = r.any(TexGen::EyeLinear);
        draw(s, any_mesh(r, frame, {.normals = true, .texcoords = true}), 20);
        s.frame = frame;
        between_draws(s);
    }
    return s.out;
}

// The bounds of fragments: viewport, scissor, window, depth range.
Case viewport_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.viewport = any_viewport(r, s.out.width, s.out.height);
        s.state.scissor = any_scissor(r, s.out.width, s.out.height);
        s.state.depth_range = any_depth_range(r);
        s.state.depth = any_depth(r);
        draw(s, any_mesh(r, s.frame, {}));
        if (r.chance(20)) add(s, any_clear(r));
        if (r.chance(10)) add(s, any_accumulate(r, s.out.profile));
        between_draws(s);
    }
    return s.out;
}

// Multi-sampling by accumulation: the same draws with other jitters [K4a].
Case jitter_case(Random& r) {
    Script s = script(r);
    const auto mesh = any_mesh(r, s.frame, {}), other = any_mesh(r, s.frame, {});
    const int frames = r.between(1, 5);
    for (int i = 0; i < frames; ++i) {
        s.state.jitter = any_jitter(r, s.out.profile);
        s.state.depth.test = true;
        add(s, Clear{mask_of(Plane::Color) | mask_of(Plane::Depth), any_color(r)});
        draw(s, mesh);
        if (r.chance(50)) s.state.jitter = any_jitter(r, s.out.profile);
        draw(s, other);
        add(s, Accumulate{i == 0 && r.chance(50) ? AccumOp::Load : AccumOp::Accum, 1});
        between_draws(s);
    }
    if (r.chance(70)) add(s, Accumulate{AccumOp::Return, 1.0f / float(frames)});
    return s.out;
}

// Polygons as outlines and corners: edge flags, facing, clipping.
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

// Lines and points: wide, steep, clipped, on grid points, textured and fogged.
Case lines_and_points_case(Random& r) {
    Script s = script(r);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        const auto width = [&r] {
            return r.chance(50) ? 1 : r.chance(80) ? r.between(2, 9) : r.between(10, 128);
        };
        s.state.line_width = width();
        s.state.point_size = width();
        s.state.depth = any_depth(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
        s.state.scissor = r.chance(20) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        s.state.clip_planes = {};
        if (r.chance(20)) any_clip_planes(r, s.frame, s.state);
        s.state.fog = r.chance(15) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        s.state.texture = any_texture_state(r);
        const MeshWish wish{.texcoords = true, .most = 8};
        draw(s, r.chance(65) ? any_lines(r, s.frame, wish) : any_points(r, s.frame, wish), 20);
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
