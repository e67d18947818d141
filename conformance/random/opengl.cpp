// What the machine has for OpenGL 1.1 beyond the papers: vertices, joined colours.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/state.h"

#include <algorithm>
#include <cmath>

namespace gw::conformance {
namespace {

/// The points of some vertices stay where they are: w scales their coordinates.
void give_w(Random& r, MeshData& mesh) {
    for (vec3& p : mesh.positions) {
        const float w = r.chance(80)   ? float(r.pick({1.0, 0.5, 2.0, 0.25, -1.0}))
                        : r.chance(50) ? float(r.real(-2, 2))
                                       : 0.0f;
        mesh.w.push_back(w);
        if (w != 0 && r.chance(80)) p *= w;
    }
}

void give_materials(Random& r, MeshData& mesh) {
    const int count = r.between(1, 4);
    for (int i = 0; i < count; ++i) mesh.materials.push_back({any_material(r), any_material(r)});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.material_indices.push_back(std::uint32_t(r.below(count)));
}

/// The mesh with attributes that only OpenGL programs give.
MeshRef extended(Random& r, const Mesh& mesh) {
    MeshData data = mesh.data();
    if (r.chance(40)) give_w(r, data);
    if (r.chance(30)) give_materials(r, data);
    if (r.chance(40))
        for (std::size_t i = 0; i < data.positions.size(); ++i)
            data.edge_flags.push_back(r.chance(60) ? 1 : 0);
    if (!data.texcoords.empty() && r.chance(40))
        for (std::size_t i = 0; i < data.texcoords.size(); ++i)
            data.texcoords_rq.push_back({float(r.real(-1, 1)), r.chance(90)
                                                                   ? float(r.real(0.25, 3))
                                                                   : float(r.real(-1, 1))});
    return make_mesh(data);
}

dvec4 any_plane(Random& r) { return {r.real(-2, 2), r.real(-2, 2), r.real(-2, 2), r.real(-2, 2)}; }

/// Mostly affine.
dmat4 any_matrix(Random& r) {
    dmat4 m(1);
    for (int c = 0; c < 4; ++c)
        for (int row = 0; row < 3; ++row) m[c][row] += r.chance(50) ? 0 : r.real(-1, 1);
    if (r.chance(30)) m[r.below(4)][3] += r.real(-0.5, 0.5);
    return m;
}

void any_coordinates(Random& r, TextureState& t) {
    t.gen = TexGen::PerCoordinate;
    for (std::size_t i = 0; i < 4; ++i) {
        t.coordinates[i].mode =
            r.any(i < 2 ? CoordinateMode::SphereMap : CoordinateMode::EyeLinear);
        if (i == 3 && r.chance(60)) t.coordinates[i].mode = CoordinateMode::Given;
        t.coordinates[i].plane = any_plane(r);
    }
}

void any_vertex_state(Random& r, State& s) {
    s.normalize = r.chance(50);
    s.color_source = r.chance(70) ? ColorSource::Lighting : ColorSource::Vertex;
    s.shade_model = r.any(ShadeModel::Smooth);
    s.polygon_mode = r.chance(60) ? PolygonMode::Fill : r.any(PolygonMode::Line);
    s.lighting = any_lighting(r);
    if (r.chance(50))
        s.lighting.color_material = {true, r.any(Face::FrontAndBack),
                                     r.any(ColorMaterial::AmbientAndDiffuse)};
    s.texture = any_texture_state(r);
    if (r.chance(40)) s.texture.gen = r.any(TexGen::EyeLinear);
    if (r.chance(50)) any_coordinates(r, s.texture);
    if (r.chance(40)) s.texture.matrix = any_matrix(r);
}

void any_values_of_draw(Random& r, Draw& d) {
    if (r.chance(60)) {
        CurrentValues v{any_color(r), vec3(any_plane(r)), vec4(any_plane(r))};
        if (r.chance(60)) v.texcoord.w = 1;
        d.current = std::make_shared<const CurrentValues>(v);
    }
    if (r.chance(40)) d.back_material = std::make_shared<const Material>(any_material(r));
    if (r.chance(15)) d.eye_from_object[r.below(4)][3] += r.real(-0.25, 0.25);
    if (r.chance(20)) d.eye_from_object[r.below(3)] *= r.pick({0.5, 3.0, -1.0, 0.0});
}

}  // namespace

// Positions of any w, materials and edges by vertex, current values, matrices of any kind.
Case vertices_case(Random& r) {
    Script s = script(r, any_opengl_profile(r));
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        any_vertex_state(r, s.state);
        s.state.fog = r.chance(25) ? any_fog(r, eye_depth(s.frame)) : FogState{};
        if (r.chance(20)) any_clip_planes(r, s.frame, s.state);
        const MeshRef mesh = any_mesh(r, s.frame,
                                      {.normals = r.chance(60),
                                       .texcoords = r.chance(60),
                                       .colors = r.chance(60),
                                       .most = 6});
        Draw d = any_draw(s, extended(r, *mesh), 50);
        any_values_of_draw(r, d);
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

namespace {

PolygonStippleState any_polygon_stipple(Random& r) {
    std::array<std::uint32_t, 32> rows;
    for (std::uint32_t& row : rows) row = r.chance(30) ? 0 : r.chance(30) ? 0xAAAAAAAA : r.bits(32);
    return {std::make_shared<const std::array<std::uint32_t, 32>>(rows)};
}

LineStippleState any_line_stipple(Random& r) {
    const int factor = r.chance(60) ? r.between(1, 4) : r.between(1, 256);
    return {r.chance(85), factor, std::uint16_t(r.chance(30) ? 0x0F0F : r.bits(16))};
}

}  // namespace

// Stipples, polygon modes of both faces, offsets of outlines.
Case stipple_case(Random& r) {
    Script s = script(r, any_opengl_profile(r));
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.depth = any_depth(r);
        s.state.cull = r.chance(30) ? any_cull(r) : CullState{};
        s.state.line_stipple = r.chance(70) ? any_line_stipple(r) : LineStippleState{};
        s.state.polygon_stipple = r.chance(50) ? any_polygon_stipple(r) : PolygonStippleState{};
        s.state.line_width = r.chance(60) ? 1 : r.between(1, 5);
        s.state.jitter = r.chance(30) ? any_jitter(r, s.out.profile) : JitterState{};
        s.state.polygon_mode = r.any(PolygonMode::Fill);
        s.state.two_side_polygon_mode = r.chance(50);
        s.state.back_polygon_mode = r.any(PolygonMode::Fill);
        s.state.polygon_offset = any_polygon_offset(r, s.out.profile);
        s.state.polygon_offset.lines = s.out.profile.extensions.polygon_offset && r.chance(60);
        s.state.polygon_offset.points = s.out.profile.extensions.polygon_offset && r.chance(60);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        const MeshWish wish{.most = 6};
        draw(s, r.chance(40) ? any_lines(r, s.frame, wish) : any_triangles(r, s.frame, wish));
        between_draws(s);
    }
    return s.out;
}

namespace {

/// Levels, formats, borders and one dimension as OpenGL programs give them.
TextureRef any_given_texture(Random& r) {
    Texture t{.name = "given"};
    t.format = r.any(TextureFormat::Intensity);
    t.dimensions = r.chance(20) ? 1 : 2;
    t.border = r.chance(35);
    int width = 1 << r.between(0, 5), height = t.dimensions == 1 ? 1 : 1 << r.between(0, 5);
    const int most = r.chance(25) ? 1 : r.chance(80) ? 13 : r.between(1, 3);
    while (int(t.levels.size()) < most) {
        TextureLevel level{width, height, {}};
        const int more = t.border ? 2 : 0;
        const int texels = (width + more) * (height + (t.dimensions == 1 ? 0 : more));
        const bool noise = r.chance(60);
        std::vector<std::uint16_t>& rgba = level.rgba.edit();
        for (int i = 0; i < 4 * texels; ++i)
            rgba.push_back(std::uint16_t(noise ? r.bits(16) : 257 * r.pick({0, 128, 255})));
        t.levels.push_back(std::move(level));
        if (width == 1 && height == 1) break;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
    return make_texture(std::move(t));
}

}  // namespace

// Texture formats, borders, given levels, one dimension, texels of fewer bits.
Case texture_formats_case(Random& r) {
    Profile profile = any_opengl_profile(r);
    if (r.chance(40)) profile.texel_bits = r.between(1, 16);
    Script s = script(r, profile);
    s.state.depth.test = r.chance(50);
    const int draws = r.between(1, 6);
    for (int i = 0; i < draws; ++i) {
        s.state.texture = any_texture_state(r);
        s.state.texture.wrap_s = r.any(Wrap::BorderClamp);
        s.state.texture.wrap_t = r.any(Wrap::BorderClamp);
        s.state.texture.border_color = any_color(r);
        if (r.chance(20)) s.state.texture.gen = r.any(TexGen::EyeLinear);
        if (r.chance(15)) s.state.texture.matrix = any_matrix(r);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.blend = r.chance(30) ? any_blend(r) : BlendState{};
        Draw d = any_draw(s, any_mesh(r, s.frame, {.texcoords = r.chance(90), .most = 6}));
        d.map = {r.chance(85) ? any_given_texture(r) : any_texture(r), {}};
        add(s, std::move(d));
        between_draws(s);
    }
    return s.out;
}

// Logical operations, every blend equation and the constant colour over a random background.
Case joined_colors_case(Random& r) {
    Script s = script(r, any_opengl_profile(r));
    add(s, any_pixels(r, s.out));
    const int draws = r.between(1, 7);
    for (int i = 0; i < draws; ++i) {
        s.state.blend = any_extended_blend(r);
        s.state.logic_op = r.chance(50) ? any_logic_op(r) : LogicOpState{};
        s.state.color_mask = any_color_mask(r);
        s.state.alpha = r.chance(20) ? any_alpha(r) : AlphaState{};
        s.state.shade_model = r.any(ShadeModel::Smooth);
        if (r.chance(25))
            add(s, any_pixels(r, s.out));
        else if (r.chance(10))
            add(s, any_spans(r, s.out));
        else
            draw(s, any_triangles(r, s.frame, {.most = 6}));
        between_draws(s);
    }
    return s.out;
}

// Rectangles of pixels under every state of fragments, textures and fog.
Case drawn_pixels_case(Random& r) {
    Script s = script(r, any_opengl_profile(r));
    copy_texture(s, r.pick({Plane::Color, Plane::Depth}));
    const int steps = r.between(2, 9);
    for (int i = 0; i < steps; ++i) {
        s.state.scissor = r.chance(25) ? any_scissor(r, s.out.width, s.out.height) : ScissorState{};
        s.state.alpha = r.chance(15) ? any_alpha(r) : AlphaState{};
        s.state.stencil = r.chance(35) ? any_stencil(r, s.out.profile) : StencilState{};
        s.state.depth = r.chance(50) ? any_depth(r) : DepthState{};
        s.state.blend = r.chance(25) ? any_extended_blend(r) : BlendState{};
        s.state.logic_op = r.chance(10) ? any_logic_op(r) : LogicOpState{};
        s.state.color_mask = any_color_mask(r);
        s.state.fog = r.chance(30) ? any_fog(r, 20) : FogState{};
        s.state.texture = any_texture_state(r);
        s.state.texture.wrap_s = r.any(Wrap::BorderClamp);
        s.state.texture.wrap_t = r.any(Wrap::BorderClamp);
        s.state.texture.border_color = any_color(r);
        s.state.texture.shadow_compare = s.out.profile.extensions.shadow_texture && r.chance(25);
        DrawPixels d = any_draw_pixels(s);
        if (r.chance(20)) {
            d.map = {any_given_texture(r), {}};
            s.state.texture.shadow_compare = false;
        }
        add(s, std::move(d));
        if (r.chance(25)) draw(s, any_triangles(r, s.frame, {.most = 4}));
        between_draws(s);
    }
    return s.out;
}

}  // namespace gw::conformance
