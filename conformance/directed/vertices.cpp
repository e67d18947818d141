// Vertices whose matrices, normals and colours leave the ordinary: determinants of 0, values that are
// no numbers, colours that lighting multiplies, edge flags where they have no effect.
#include "conformance/cases.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {
namespace {

constexpr int vertex_window = 20;

LightsRef one_light(const Light& light) {
    return std::make_shared<const std::vector<Light>>(std::vector<Light>{light});
}

void begin_lighting(Script& s) {
    s.state = {.projection = s.state.projection};
    s.state.color_source = ColorSource::Lighting;
}

MeshData whole_window() { return rectangle(0, 0, vertex_window, vertex_window); }

/// [R6.28] Without normalize: a determinant of 0, one that overflows, one that scales.
void draw_unnormalized(Script& s) {
    Random& r = s.random;
    begin_lighting(s);
    s.state.normalize = false;
    s.state.projection[2][2] = 0;
    MeshData data = whole_window();
    data.normals.assign(4, {0, 0, 1});
    Draw d{.mesh = make_mesh(data)};
    d.material.Kd = vec3(0.75f);
    d.lights = one_light({.position = {0, 0, 1, 0}});
    d.eye_from_object[2] = dvec4(0);
    add(s, d);
    d.eye_from_object[2].z = r.real(1.5, 3);
    add(s, d);
    // [R6.11] A mirror keeps the side of the normals.
    s.state.normalize = true;
    d.eye_from_object[0].x = -1;
    d.eye_from_object[3].x = vertex_window;
    add(s, d);
    s.state.normalize = false;
    d.eye_from_object = dmat4(1);
    // One component of the normal is no number: it becomes -2^200.
    d.eye_from_object[1] = {0, 1, 0, 0};
    d.eye_from_object[2] = {0, 1e200, 1e200, 0};
    d.eye_from_object[1].z = 1e200;
    for (const float side : {-1.0f, 1.0f}) {
        d.lights = one_light({.position = {side, 0, 0, 0}});
        add(s, d);
    }
}

/// [R2.7] The length of the normal is no number, so its unit is 0: a reflection is straight on.
/// The line is where y and z are 0, and its eye coordinates stay small.
void draw_without_length(Script& s) {
    Random& r = s.random;
    s.state = {.projection = s.state.projection};
    s.state.projection[2][2] = 0;
    s.state.line_width = 12;
    s.state.texture = {.gen = TexGen::SphereMap};
    s.state.texture.env = TexEnv::Replace;
    MeshData data{.primitive = Primitive::Lines, .positions = {{1, 0, 0}, {19, 0, 0}}};
    data.normals.assign(2, {0, 0, 1});
    Draw d{.mesh = make_mesh(data)};
    d.eye_from_object[1] = {0, 1e200, 0, 0};
    d.eye_from_object[2] = {0, 0, 1e200, 0};
    d.eye_from_object[3] = {0, 10, -r.real(4, 9), 1};
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 64; ++i) texels.push_back(std::uint16_t(r.bits(16)));
    d.map.texture = make_texture("noise", 8, 8, texels);
    for (const TexGen gen : {TexGen::SphereMap, TexGen::RefractionMap}) {
        s.state.texture.gen = gen;
        add(s, d);
    }
}

/// [R2.6] The eye's z is no number: the fog of fragments is full.
void draw_without_distance(Script& s) {
    s.state = {.projection = s.state.projection};
    s.state.projection[2][2] = 0;
    s.state.fog = {.enable = true, .mode = FogMode::Linear, .start = 1, .end = 9};
    s.state.fog.color = {0.25f, 0.5f, 0.75f, 1};
    s.state.fog.coordinate = FogCoordinate::Fragment;
    Draw d{.mesh = make_mesh(rectangle(4, 4, 18, 18))};
    d.eye_from_object[0].z = 1e308;
    d.eye_from_object[1].z = -1e308;
    add(s, d);
}

/// [R2.7] The first two and the last two products are summed first. The distance to the plane is 0
/// everywhere; summed from left to right it is -1/2.
void draw_on_a_plane(Script& s) {
    s.state = {.projection = s.state.projection};
    s.state.projection[2][2] = 0;
    s.state.clip_planes[0] = {true, {0x1p60, 0, -0x1p60, -0.5}};
    MeshData data = rectangle(2, 2, 18, 18);
    for (vec3& p : data.positions) p.z = p.x;
    add(s, Draw{.mesh = make_mesh(data)});
}

/// [R3.5] A highlight with the exponent 0 whose half-way vector is behind the surface.
void draw_highlight_of_exponent_0(Script& s) {
    begin_lighting(s);
    s.state.projection[2][2] = 0;
    s.state.projection[3].x -= 2 * 1000.0 / vertex_window;
    s.state.lighting.local_viewer = true;
    MeshData data = whole_window();
    data.normals.assign(4, {1, 0, 0});
    Draw d{.mesh = make_mesh(data)};
    d.eye_from_object[3].x = 1000;
    d.material.Kd = vec3(0.25f);
    d.material.Ks = vec3(0.5f);
    d.lights = one_light({.position = {0.6f, 0, 0.8f, 0}});
    add(s, d);
    s.state.projection[3].x += 2 * 1000.0 / vertex_window;
}

/// [R8.10] Colours below 1/4 that lights multiply: a rounded one would be wrong by several units.
void draw_color_materials(Script& s) {
    Random& r = s.random;
    begin_lighting(s);
    s.state.lighting.two_side = true;
    s.state.lighting.model_ambient = {2, 3, 4, 1};
    MeshData data = whole_window();
    data.normals.assign(4, {0, 0, 1});
    for (int i = 0; i < 4; ++i)
        data.colors.push_back({float(r.real(0, 0.25)), float(r.real(0, 0.25)),
                               float(r.real(0, 0.25)), float(r.real(0, 1))});
    Draw d{.mesh = make_mesh(data)};
    d.lights = one_light({.position = {0, 0, 1, 0}, .Ia = vec3(0.5f), .Id = {3, 2, 4}});
    for (int mode = 0; mode <= int(ColorMaterial::AmbientAndDiffuse); ++mode) {
        s.state.lighting.color_material = {true, r.pick({Face::Front, Face::FrontAndBack}),
                                           ColorMaterial(mode)};
        add(s, d);
    }
}

/// [R5.9] Meshes without attributes have the draw's, q included.
void draw_current_values(Script& s) {
    Random& r = s.random;
    CurrentValues values{any_color(r), {0.6f, 0, 0.8f}, {0, 0, 0, 1}};
    for (int i = 0; i < 3; ++i) values.texcoord[i] = float(r.real(0.1, 0.9));
    values.texcoord.w = float(r.real(1.5, 3));
    Draw d{.mesh = make_mesh(whole_window())};
    d.current = std::make_shared<const CurrentValues>(values);
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 64; ++i) texels.push_back(std::uint16_t(r.bits(16)));
    d.lights = one_light({.position = {0, 0, 1, 0}});
    add(s, Clear{mask_of(Plane::Color)});
    for (const ColorSource source : {ColorSource::Vertex, ColorSource::Lighting}) {
        s.state = {.projection = s.state.projection};
        s.state.color_source = source;
        add(s, d);
    }
    s.state.texture.env = TexEnv::Replace;
    d.map.texture = make_texture("noise", 8, 8, texels);
    add(s, d);
}

/// [R6.18] Two planes cut each triangle; fog at the vertex is not rounded between them.
void draw_fog_cut_twice(Script& s) {
    Random& r = s.random;
    s.state = {.projection = s.state.projection};
    s.state.projection[2][2] = 0;
    s.state.fog = {.enable = true, .mode = FogMode::Linear, .start = 0, .end = 9};
    s.state.fog.coordinate = FogCoordinate::Vertex;
    s.state.clip_planes[0] = {true, {1, 0.5, 0, -12}};
    s.state.clip_planes[1] = {true, {-0.25, 1, 0, -4}};
    for (int i = 0; i < 4; ++i) {
        MeshData data{.positions = {{-9, -8, 0}, {38, -3, 0}, {7, 37, 0}}};
        for (vec3& p : data.positions) p.z = float(-r.real(0, 9));
        add(s, Draw{.mesh = make_mesh(data)});
    }
}

/// [R10.4] The texture's planes see x, y, z, w of eye space, and not the point.
void draw_linear_coordinates(Script& s) {
    Random& r = s.random;
    s.state = {.projection = s.state.projection};
    s.state.texture.gen = TexGen::EyeLinear;
    s.state.texture.env = TexEnv::Replace;
    s.state.texture.eye_linear = dmat4(1.0 / vertex_window);
    s.state.texture.eye_linear[3] = {0, 0, 0, 1};
    MeshData data = whole_window();
    for (vec3& p : data.positions) {
        data.w.push_back(r.pick({0.5f, 2.0f, 4.0f}));
        p *= data.w.back();
    }
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 64; ++i) texels.push_back(std::uint16_t(257 * r.bits(8)));
    add(s, Draw{.mesh = make_mesh(data), .map = {make_texture("noise", 8, 8, texels), {}}});
}

/// A point straight before the eye and below a light.
void draw_on_the_axis(Script& s) {
    Random& r = s.random;
    begin_lighting(s);
    s.state.projection[2][2] = 0;
    s.state.projection[3] = {0, 0, 0, 1};
    s.state.point_size = 9;
    MeshData data{.primitive = Primitive::Points, .positions = {{0, 0, -5}}};
    data.normals = {{0, 0, 1}};
    Draw d{.mesh = make_mesh(data)};
    d.lights = one_light({.position = {0, 0, 7, 1}, .spot_cos_cutoff = 1});  // [R8.5] c is 1
    add(s, d);
    // [R10.2] Without a normal the reflection is (0, 0, -1).
    s.state.color_source = ColorSource::Vertex;
    s.state.texture.gen = TexGen::SphereMap;
    s.state.texture.env = TexEnv::Replace;
    data.normals = {{0, 0, 0}};
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 4 * 64; ++i) texels.push_back(std::uint16_t(257 * r.bits(8)));
    add(s, Draw{.mesh = make_mesh(data), .map = {make_texture("noise", 8, 8, texels), {}}});
}

/// [R6.29] Strips and fans have all their edges, whatever the flags.
void draw_flagged_outlines(Script& s) {
    Random& r = s.random;
    s.state = {.projection = s.state.projection};
    for (const Primitive primitive : {Primitive::TriangleStrip, Primitive::TriangleFan,
                                      Primitive::Quads, Primitive::Polygons}) {
        s.state.polygon_mode = r.any(PolygonMode::Line);
        s.state.point_size = 3;
        MeshData data{.primitive = primitive};
        data.positions = {{2, 2, 0}, {17, 3, 0}, {18, 18, 0}, {3, 16, 0}};
        if (primitive == Primitive::TriangleStrip) std::swap(data.positions[2], data.positions[3]);
        for (int i = 0; i < 4; ++i) {
            data.edge_flags.push_back(std::uint8_t(i % 2));
            data.colors.push_back(any_color(r));
        }
        add(s, Clear{mask_of(Plane::Color), any_color(r)});
        add(s, Draw{.mesh = make_mesh(data)});
    }
}

}  // namespace

Case vertex_rules_case(Random& r) {
    Profile profile = opengl_up_to(&Extensions::draw_pixels);
    profile.color_bits = profile.lit_bits = r.pick({8, 12});
    Script s = pixel_script(r, profile, vertex_window, vertex_window);
    const dmat4 projection = s.state.projection;
    for (const auto part :
         {draw_unnormalized, draw_without_length, draw_without_distance, draw_on_a_plane,
          draw_highlight_of_exponent_0, draw_color_materials, draw_current_values,
          draw_fog_cut_twice, draw_linear_coordinates, draw_on_the_axis, draw_flagged_outlines}) {
        part(s);
        s.state.projection = projection;
    }
    return s.out;
}

}  // namespace gw::conformance
