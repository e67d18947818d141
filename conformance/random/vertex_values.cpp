// Values of vertices that OpenGL 1.4 added, secondary colours and fog coordinates; queries of 1.5.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <optional>
#include <utility>

namespace gw::conformance {
namespace {

vec3 any_secondary(Random& r) { return {any_fraction(r), any_fraction(r), any_fraction(r)}; }

/// About 0 to `depth`, and far from it.
float any_fog_coordinate(Random& r, double depth) {
    const int kind = r.below(20);
    if (kind == 0) return float(r.scaled(-1, 1, -100, 120));
    if (kind == 1) return r.pick({0.0f, -0.0f, 1e38f, -1e38f, 1e-40f});
    return float(r.real(kind < 8 ? -0.7 : 0, 1.3) * depth);
}

MeshRef with_secondary_colors(Random& r, const Mesh& mesh) {
    MeshData data = mesh.data();
    const vec3 all = any_secondary(r);
    const bool constant = r.chance(15);
    for (std::size_t i = 0; i < data.positions.size(); ++i)
        data.secondary_colors.push_back(constant ? all : any_secondary(r));
    return make_mesh(std::move(data));
}

MeshRef with_fog_coordinates(Random& r, const Mesh& mesh, double depth) {
    MeshData data = mesh.data();
    const float all = any_fog_coordinate(r, depth);
    const bool constant = r.chance(15);
    for (std::size_t i = 0; i < data.positions.size(); ++i)
        data.fog_coordinates.push_back(constant ? all : any_fog_coordinate(r, depth));
    return make_mesh(std::move(data));
}

void smooth_some(Random& r, const Profile& p, State& s) {
    const bool smooth = p.coverage_bits > 0 && r.chance(20);
    s.point_smooth = s.line_smooth = s.polygon_smooth = smooth;
    s.blend = smooth || r.chance(25)
                  ? BlendState{true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha}
                  : BlendState{};
}

/// Draws, or draws again under Equal.
void draw_twice_some(Script& s, Draw d) {
    Random& r = s.random;
    s.state.depth = {.test = r.chance(60), .func = DepthFunc::LEqual};
    add(s, d);
    if (!s.state.depth.test || !r.chance(40)) return;
    s.state.depth.func = DepthFunc::Equal;
    s.state.color_sum = r.chance(50);
    add(s, std::move(d));
}

}  // namespace

// Secondary colours of vertices and of lights, flat and smooth, of both sides, textured and in fog.
Case secondary_color_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::fog_coordinate));
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        State& state = s.state;
        state.color_source = r.chance(55) ? ColorSource::Vertex : ColorSource::Lighting;
        if (r.chance(12)) state.color_source = ColorSource::PolygonId;
        state.color_sum = r.chance(75);
        state.lighting = any_lighting(r);
        state.lighting.separate_specular = r.chance(75);
        state.lighting.two_side = r.chance(70);
        state.shade_model = r.chance(30) ? ShadeModel::Flat : ShadeModel::Smooth;
        state.cull = r.chance(30) ? any_cull(r) : CullState{};
        state.polygon_mode = r.chance(80) ? PolygonMode::Fill : r.any<PolygonMode>();
        state.texture = any_texture_state(r);
        state.fog = r.chance(30) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        smooth_some(r, s.out.profile, state);
        MeshRef mesh =
            any_mesh(r, s.frame, {.normals = r.chance(95), .texcoords = r.chance(90), .most = 6});
        if (r.chance(75)) mesh = with_secondary_colors(r, *mesh);
        Draw d = any_draw(s, std::move(mesh), 40);
        if (d.lights && r.chance(80)) d.material.Ks = any_secondary(r);
        CurrentValues current;
        current.color = any_color(r);
        current.secondary_color = any_secondary(r);
        if (r.chance(70)) d.current = std::make_shared<const CurrentValues>(current);
        if (r.chance(30)) d.back_material = std::make_shared<const Material>(any_material(r));
        draw_twice_some(s, std::move(d));
        if (r.chance(35)) {
            DrawPixels pixels = any_draw_pixels(s);
            pixels.raster.secondary_color = any_pixel(r, s.out.profile.color_bits);
            add(s, std::move(pixels));
        }
        between_draws(s);
    }
    return s.out;
}

// Fog by given coordinates, in every mode, at the vertex and per fragment.
Case fog_coordinate_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::fog_coordinate));
    const double depth = eye_depth(s.frame);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.fog = any_fog(r, depth);
        s.state.fog.source = r.chance(85) ? FogSource::Coordinate : FogSource::Depth;
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.color_sum = r.chance(20);
        s.state.texture = any_texture_state(r);
        smooth_some(r, s.out.profile, s.state);
        MeshRef mesh = any_mesh(r, s.frame, {.texcoords = true, .most = 6});
        if (r.chance(80)) mesh = with_fog_coordinates(r, *mesh, depth);
        Draw d = any_draw(s, std::move(mesh), 20);
        CurrentValues current;
        current.fog_coordinate = any_fog_coordinate(r, depth);
        if (r.chance(70)) d.current = std::make_shared<const CurrentValues>(current);
        draw_twice_some(s, std::move(d));
        if (r.chance(35)) {
            DrawPixels pixels = any_draw_pixels(s);
            pixels.raster.fog_coordinate = any_fog_coordinate(r, depth);
            add(s, std::move(pixels));
        }
        between_draws(s);
    }
    return s.out;
}

// Both origins and both ranges of depth, under every viewport, clip plane and culling.
Case clip_control_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::clip_control));
    const int draws = r.between(2, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.clip_control = {r.any<ClipOrigin>(), r.any<ClipDepth>()};
        s.state.viewport =
            r.chance(40) ? any_viewport(r, s.out.width, s.out.height) : ViewportState{};
        s.state.depth_range = any_depth_range(r);
        s.state.depth = any_depth(r);
        s.state.cull = r.chance(60) ? any_cull(r) : CullState{};
        s.state.polygon_mode = r.chance(75) ? PolygonMode::Fill : r.any<PolygonMode>();
        s.state.two_side_polygon_mode = r.chance(25);
        s.state.back_polygon_mode = r.any<PolygonMode>();
        s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
        for (ClipPlane& plane : s.state.clip_planes) plane.enable = false;
        if (r.chance(25)) any_clip_planes(r, s.frame, s.state);
        const bool lit = r.chance(30);
        s.state.color_source = lit ? ColorSource::Lighting : ColorSource::Vertex;
        s.state.lighting.two_side = true;
        draw(s, any_mesh(r, s.frame, {.normals = true, .most = 6}));
        between_draws(s);
    }
    return s.out;
}

// Queries that begin and end anywhere.
Case occlusion_query_case(Random& r) {
    Script s = script(r, any_opengl_profile(r, &Extensions::occlusion_query));
    std::optional<std::uint32_t> active;
    const int steps = r.between(4, 16);
    for (int i = 0; i < steps; ++i) {
        if (r.chance(45)) {
            const std::uint32_t key = active.value_or(std::uint32_t(r.below(3)));
            add(s, Query{key, !active});
            active = active ? std::nullopt : std::optional(key);
        }
        s.state.depth = any_depth(r);
        s.state.alpha = r.chance(30) ? any_alpha(r) : AlphaState{};
        s.state.stencil = r.chance(30) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.color_mask = any_color_mask(r);
        const int kind = r.below(10);
        if (kind < 7) draw(s, any_mesh(r, s.frame, {.most = 5}));
        if (kind == 7) add(s, any_pixels(r, s.out));
        if (kind == 8) add(s, any_spans(r, s.out));
        if (kind == 9) add(s, any_draw_pixels(s));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
