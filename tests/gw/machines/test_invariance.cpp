// Multi-pass invariance: coverage and Z depend on the fields that docs/manual/machine.md, "Stages",
// lists, and on no other. Every other field is changed between a depth pass and a pass under Equal:
// each fragment that passed must pass again.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "tests/fuzz/run.h"

#include <gtest/gtest.h>

namespace gw::fuzz {
namespace {

/// A change of one field that kills no fragment before the depth test.
struct Change {
    const char* field;
    void (*state)(State&);
    void (*draw)(Draw&) = nullptr;
};

constexpr ColorMask no_color{false, false, false, false};

const Change changes[] = {
    {"nothing", [](State&) {}},
    {"shade_model", [](State& s) { s.shade_model = ShadeModel::Flat; }},
    {"color_source Lighting", [](State& s) { s.color_source = ColorSource::Lighting; }},
    {"color_source PolygonId", [](State& s) { s.color_source = ColorSource::PolygonId; }},
    {"lighting.local_viewer",
     [](State& s) {
         s.color_source = ColorSource::Lighting;
         s.lighting.local_viewer = true;
     }},
    {"lighting.two_side",
     [](State& s) {
         s.color_source = ColorSource::Lighting;
         s.lighting.two_side = true;
     }},
    {"lighting.model_ambient",
     [](State& s) {
         s.color_source = ColorSource::Lighting;
         s.lighting.model_ambient = vec4(1);
     }},
    {"fog at the vertex",
     [](State& s) { s.fog = {.enable = true, .coordinate = FogCoordinate::Vertex}; }},
    {"fog per fragment",
     [](State& s) { s.fog = {.enable = true, .coordinate = FogCoordinate::Fragment}; }},
    {"fog.mode Linear",
     [](State& s) { s.fog = {.enable = true, .mode = FogMode::Linear, .start = -1, .end = 9}; }},
    {"fog.mode Exp2",
     [](State& s) { s.fog = {.enable = true, .mode = FogMode::Exp2, .density = 0.1f}; }},
    {"texture min_filter", [](State& s) { s.texture.min_filter = MinFilter::LinearMipmapLinear; }},
    {"texture mag_filter", [](State& s) { s.texture.mag_filter = MagFilter::Nearest; }},
    {"texture wrap_s", [](State& s) { s.texture.wrap_s = Wrap::Clamp; }},
    {"texture wrap_t", [](State& s) { s.texture.wrap_t = Wrap::Clamp; }},
    {"texture env", [](State& s) { s.texture.env = TexEnv::Replace; }},
    {"texture env_color",
     [](State& s) {
         s.texture.env = TexEnv::Blend;
         s.texture.env_color = vec4(1);
     }},
    {"texture gen SphereMap", [](State& s) { s.texture.gen = TexGen::SphereMap; }},
    {"texture gen RefractionMap",
     [](State& s) {
         s.texture.gen = TexGen::RefractionMap;
         s.texture.eta = 0.7;
     }},
    {"texture gen EyeLinear",
     [](State& s) { s.texture.gen = TexGen::EyeLinear, s.texture.eye_linear[2][3] = 1; }},
    {"cull.face, off", [](State& s) { s.cull.face = Face::FrontAndBack; }},
    {"cull.front", [](State& s) { s.cull.front = Winding::CW; }},
    {"scissor around all",
     [](State& s) {
         s.scissor = {true, {0, 0, 4096, 4096}};
     }},
    {"alpha",
     [](State& s) {
         s.alpha = {true, AlphaFunc::GEqual, 0};
     }},
    {"alpha.ref",
     [](State& s) {
         s.alpha = {true, AlphaFunc::LEqual, 1};
     }},
    {"stencil", [](State& s) { s.stencil = {.test = true}; }},
    {"stencil.zpass", [](State& s) { s.stencil = {.test = true, .zpass = StencilOp::Incr}; }},
    {"stencil.zfail", [](State& s) { s.stencil = {.test = true, .zfail = StencilOp::Invert}; }},
    {"stencil.func", [](State& s) { s.stencil = {.test = true, .func = StencilFunc::LEqual}; }},
    {"stencil.mask",
     [](State& s) { s.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 5, .mask = 0}; }},
    {"blend",
     [](State& s) {
         s.blend = {true, BlendFactor::One, BlendFactor::One};
     }},
    {"blend factors",
     [](State& s) {
         s.blend = {true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
     }},
    {"color_mask",
     [](State& s) {
         s.color_mask = {true, false, true, false};
     }},
    {"color_mask_bits", [](State& s) { s.color_mask_bits = {.r = 0x0F, .g = 0, .a = 0x55}; }},
    {"draw_buffer none", [](State& s) { s.draw_buffer = DrawBuffer::None; }},
    {"draw_buffer", [](State& s) { s.draw_buffer = DrawBuffer::FrontAndBack; }},
    {"read_buffer", [](State& s) { s.read_buffer = ReadBuffer::Back; }},
    {"color_mask none", [](State& s) { s.color_mask = no_color; }},
    // Widths matter only to lines and points: filled faces do not have them.
    {"point_size", [](State& s) { s.point_size = s.polygon_mode == PolygonMode::Fill ? 7 : 1; }},
    {"line_width", [](State& s) { s.line_width = s.polygon_mode == PolygonMode::Fill ? 7 : 1; }},
    {"diamond_lines", [](State& s) { s.diamond_lines = s.polygon_mode == PolygonMode::Fill; }},
    {"point_parameters",
     [](State& s) {
         if (s.polygon_mode == PolygonMode::Fill)
             s.point_parameters = {.linear = 1, .min_size = 7, .max_size = 9};
     }},
    {"point_sprite", [](State& s) { s.point_sprite = s.texture.coord_replace = true; }},
    {"multisample",
     [](State& s) { s.multisample = {.alpha_to_one = true, .coverage_test = true}; }},
    {"sizes in parts of a pixel", [](State& s) { s.point_size = s.line_width = 1.25f; }},
    {"normalize", [](State& s) { s.normalize = false; }},
    {"lighting.color_material",
     [](State& s) {
         s.color_source = ColorSource::Lighting;
         s.lighting.color_material.enable = true;
     }},
    {"color_sum", [](State& s) { s.color_sum = true; }},
    {"lighting.separate_specular",
     [](State& s) {
         s.color_source = ColorSource::Lighting;
         s.lighting.separate_specular = true;
     }},
    {"fog.source", [](State& s) { s.fog = {.enable = true, .source = FogSource::Coordinate}; }},
    {"texture.matrix",
     [](State& s) {
         s.texture.matrix[0] = {2, 1, 0, 1};
     }},
    {"texture.coordinates",
     [](State& s) {
         s.texture.gen = TexGen::PerCoordinate;
         s.texture.coordinates[0] = {CoordinateMode::ObjectLinear, {1, 2, 3, 4}};
     }},
    {"more_textures",
     [](State& s) {
         std::array<TextureState, max_texture_units - 1> units;
         units[1].gen = TexGen::EyeLinear;
         s.more_textures.units = std::make_shared<const decltype(units)>(units);
     },
     [](Draw& d) {
         d.more_maps = std::make_shared<const MoreBindings>(MoreBindings{d.map, d.map, d.map});
     }},
    {"draw: current values", [](State&) {},
     [](Draw& d) { d.current = std::make_shared<const CurrentValues>(CurrentValues{vec4(0.5f)}); }},
    {"draw: no map", [](State&) {}, [](Draw& d) { d.map = {}; }},
    {"draw: material", [](State& s) { s.color_source = ColorSource::Lighting; },
     [](Draw& d) { d.material = {.Ka = vec3(1), .Ks = vec3(1), .Ns = 30, .alpha = 0}; }},
    {"draw: no lights", [](State& s) { s.color_source = ColorSource::Lighting; },
     [](Draw& d) { d.lights = {}; }},
    {"draw: id_base", [](State& s) { s.color_source = ColorSource::PolygonId; },
     [](Draw& d) {
         d.id_base = 77;
         d.id_shift = 3;
     }},
    {"mesh: other normals, texture coordinates, colours", [](State&) {},
     [](Draw& d) {
         MeshData data = d.mesh->data();
         data.normals.assign(data.positions.size(), vec3(1, 2, 3));
         data.texcoords.assign(data.positions.size(), vec2(70, -3));
         data.colors.assign(data.positions.size(), vec4(0.5f));
         data.secondary_colors.assign(data.positions.size(), vec3(0.5f));
         data.fog_coordinates.assign(data.positions.size(), -3);
         d.mesh = make_mesh(std::move(data));
     }},
};

/// Fails to compile when State gets a field, which must enter the manual's list or `changes`.
[[maybe_unused]] void every_field_is_known(const State& state) {
    [[maybe_unused]] const auto& [projection, normalize, viewport, depth_range, clip_control,
                                  clip_planes, cull, polygon_mode, two_side_polygon_mode,
                                  back_polygon_mode, line_stipple, polygon_stipple, polygon_offset,
                                  jitter, point_size, point_parameters, point_sprite, line_width,
                                  diamond_lines, point_smooth, line_smooth, polygon_smooth,
                                  shade_model, color_source, lighting, color_sum, fog, texture,
                                  more_textures, scissor, alpha, stencil, depth, blend, logic_op,
                                  color_mask, color_mask_bits, multisample, draw_buffer,
                                  read_buffer] = state;
}

struct Scene {
    Case where;
    State state;
    std::vector<Draw> draws;
};

Scene any_scene(std::uint64_t seed) {
    Random r(seed);
    Script s = script(r);
    s.state.color_source = ColorSource::Lighting;  // so that draws have materials and lights
    s.state.polygon_mode = r.chance(85) ? PolygonMode::Fill : PolygonMode::Line;
    s.state.jitter = any_jitter(r, s.out.profile);
    if (r.chance(20)) any_clip_planes(r, s.frame, s.state);
    const int draws = r.between(1, 3);
    for (int i = 0; i < draws; ++i)
        draw(s, any_triangles(r, s.frame, {.normals = true, .texcoords = true}), 100);
    Scene scene{s.out, s.state, {}};
    scene.where.profile.color_planes = 2;
    scene.where.profile.extensions.secondary_color = true;
    scene.where.profile.extensions.fog_coordinate = true;
    scene.where.profile.extensions.texture_units = true;
    scene.where.profile.extensions.point_parameters = true;
    scene.where.profile.extensions.point_sprite = true;
    scene.where.profile.extensions.multisample = true;
    scene.state.color_source = ColorSource::Vertex;
    for (const Command& command : s.out.list.commands)
        if (const auto* draw = std::get_if<Draw>(&command)) scene.draws.push_back(*draw);
    return scene;
}

/// The counters of the pass under Equal, with one change in the depth pass and one in this pass.
Counters second_pass(const Scene& scene, const Change& first, const Change& second) {
    CommandList list;
    list.add(Clear{.planes = all_planes, .depth = 1});
    for (const Change* change : {&first, &second}) {
        list.add(BeginPass{change->field});
        State state = scene.state;
        change->state(state);
        state.depth = change == &first ? DepthState{true, DepthFunc::LEqual, true}
                                       : DepthState{true, DepthFunc::Equal, false};
        list.add(SetState{state});
        for (Draw draw : scene.draws) {
            if (change->draw) change->draw(draw);
            list.add(std::move(draw));
        }
    }
    const auto machine = machine_named("fast")(scene.where, 1);
    machine->execute(list);
    return machine->passes().back().counters;
}

void PrintTo(const Change& change, std::ostream* out) { *out << change.field; }

class Invariance : public testing::TestWithParam<Change> {};

TEST_P(Invariance, CoverageAndZDoNotDependOnThisField) {
    std::uint64_t made = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Scene scene = any_scene(seed);
        const Counters plain = second_pass(scene, changes[0], changes[0]);
        for (const Counters& changed : {second_pass(scene, changes[0], GetParam()),
                                        second_pass(scene, GetParam(), changes[0])}) {
            EXPECT_EQ(changed.fragments, plain.fragments) << "seed " << seed;
            EXPECT_EQ(changed.depth_killed, plain.depth_killed) << "seed " << seed;
            EXPECT_EQ(changed.written, plain.written) << "seed " << seed;
        }
        made += plain.written;
    }
    EXPECT_GT(made, 1000u);
}

std::string name_of_change(const testing::TestParamInfo<Change>& info) {
    std::string name;
    for (const char c : std::string(info.param.field))
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Fields, Invariance, testing::ValuesIn(changes), name_of_change);

}  // namespace
}  // namespace gw::fuzz
