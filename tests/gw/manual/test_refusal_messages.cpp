// docs/manual/commands.md, "Refusals": every message of the page happens, and no other one does.
// [R1.4] [R1.7] [R1.11] [R5.7] [R5.8]
#include "gw/error.h"
#include "gw/machine.h"
#include "test_paths.h"
#include "tests/gw/manual_textures/refused_textures.h"
#include "tests/gw/surfaces/refused_samples.h"
#include "tests/gw/surfaces/refused_surfaces.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <regex>
#include <set>

namespace gw {
namespace {

/// The messages of the page's two tables, their last column.
std::vector<std::string> messages_of_the_page() {
    std::ifstream page(GW_SOURCE_DIR "/docs/manual/commands.md");
    std::vector<std::string> out;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) inside = line == "## Refusals";
        if (!inside || !line.starts_with("| ") || line.find("| message") != line.npos) continue;
        const std::size_t bar = line.rfind(" |"), start = line.rfind("| ", bar - 1) + 2;
        out.push_back(line.substr(start, bar - start));
    }
    return out;
}

/// Single capitals are placeholders for values.
std::regex pattern_of(const std::string& message) {
    std::string out;
    for (const char c : message) {
        if (std::string("()[].*+?^$|\\").find(c) != std::string::npos) out += '\\';
        out += c;
    }
    out = std::regex_replace(out, std::regex(R"(\bWxH\b)"), "\\d+x\\d+");
    return std::regex(std::regex_replace(out, std::regex(R"(\b([A-Z]|FIELD)\b)"), "[^;]*"));
}

std::string message_of(const std::function<void()>& refused) {
    try {
        refused();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// What a list of these commands is refused with on vgx in 16 x 16 pixels, without "command N".
std::string refusal(std::vector<Command> commands, const Profile& profile = vgx()) {
    const std::string text = message_of([&] { validate({commands}, profile, 16, 16); });
    const std::string head = "command " + std::to_string(commands.size() - 1) + " (";
    if (!text.starts_with(head)) return text.empty() ? "not refused" : text;
    return text.substr(text.find("): ") + 3);
}

constexpr float nan = NAN, infinity = INFINITY;
std::string refused_state(const std::function<void(State&)>& change,
                          const Profile& profile = vgx()) {
    SetState set;
    change(set.state.edit());
    return refusal({set}, profile);
}

MeshRef a_mesh() { return make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}); }

std::string refused_draw(const std::function<void(Draw&)>& change) {
    Draw draw{.mesh = a_mesh()};
    change(draw);
    return refusal({draw});
}

std::string refused_light(const std::function<void(Light&)>& change) {
    Light light;
    change(light);
    return refused_draw(
        [&](Draw& d) { d.lights = std::make_shared<const std::vector<Light>>(1, light); });
}

std::vector<std::string> refused_states() {
    std::vector<std::string> out;
    const auto add = [&](const std::function<void(State&)>& f) { out.push_back(refused_state(f)); };
    add([](State& s) { s.polygon_offset.enable = true; });
    add([](State& s) { s.cull.face = Face(9); });
    add([](State& s) { s.projection[2][1] = infinity; });
    add([](State& s) { s.viewport = {0, 0, 4097, 1}; });
    add([](State& s) { s.viewport = {0, 0, 1, 0}; });
    add([](State& s) { s.viewport.x = -4097; });
    add([](State& s) { s.viewport.y = 4097; });
    add([](State& s) { s.depth_range.near_value = nan; });
    add([](State& s) { s.depth_range.far_value = infinity; });
    add([](State& s) { s.clip_planes[5].plane.w = nan; });
    add([](State& s) { s.jitter.x = 8; });
    add([](State& s) { s.jitter.y = -8; });
    add([](State& s) { s.point_size = 0; });
    add([](State& s) { s.line_width = 129; });
    add([](State& s) { s.line_stipple.factor = 257; });
    add([](State& s) { s.polygon_offset.factor = infinity; });
    add([](State& s) { s.polygon_offset.units = nan; });
    add([](State& s) { s.blend.color.y = nan; });
    add([](State& s) { s.draw_buffer = DrawBuffer::Back; });
    add([](State& s) { s.draw_buffer = DrawBuffer::FrontAndBack; });
    add([](State& s) { s.draw_buffer = DrawBuffer(4); });
    add([](State& s) { s.read_buffer = ReadBuffer::Back; });
    add([](State& s) { s.read_buffer = ReadBuffer(2); });
    for (const BlendFactor f : {BlendFactor::SrcColor, BlendFactor::OneMinusSrcColor}) {
        add([f](State& s) { s.blend.src = f; });
        add([f](State& s) { s.blend.alpha.src = f; });
    }
    for (const BlendFactor f :
         {BlendFactor::DstColor, BlendFactor::OneMinusDstColor, BlendFactor::SrcAlphaSaturate}) {
        add([f](State& s) { s.blend.dst = f; });
        add([f](State& s) { s.blend.alpha.dst = f; });
    }
    add([](State& s) { s.fog = {.enable = true, .start = nan}; });
    add([](State& s) { s.fog = {.enable = true, .end = infinity}; });
    add([](State& s) {
        s.fog.enable = true;
        s.fog.color.y = nan;
    });
    add([](State& s) { s.fog = {.enable = true, .mode = FogMode::Linear, .start = 2, .end = 2}; });
    add([](State& s) { s.fog = {.enable = true, .mode = FogMode::Exp2, .density = 0}; });
    add([](State& s) { s.scissor.box.height = -1; });
    add([](State& s) { s.alpha.ref = nan; });
    add([](State& s) { s.lighting.model_ambient.z = nan; });
    add([](State& s) { s.texture.eta = nan; });
    add([](State& s) { s.texture.eye_linear[3][3] = nan; });
    add([](State& s) { s.texture.env_color.x = infinity; });
    add([](State& s) { s.texture.coordinates[2].plane.w = nan; });
    add([](State& s) { s.texture.matrix[1][0] = infinity; });
    add([](State& s) { s.texture.border_color.w = nan; });
    add([](State& s) { s.texture.combine_rgb.scale = 3; });
    add([](State& s) { s.texture.combine_alpha.scale = 0; });
    add([](State& s) { s.texture.combine_alpha.func = CombineFunc::Dot3Rgb; });
    const auto add_level = [&](auto TextureLodState::*member, auto value) {
        out.push_back(refused_state([&](State& s) { s.texture.lod.*member = value; }, opengl()));
    };
    for (const auto f : {&TextureLodState::bias, &TextureLodState::min, &TextureLodState::max})
        add_level(f, nan);
    add_level(&TextureLodState::base_level, 1001);
    const auto add_points = [&](float PointParameters::*member, float value) {
        out.push_back(
            refused_state([&](State& s) { s.point_parameters.*member = value; }, opengl()));
    };
    for (const auto f :
         {&PointParameters::constant, &PointParameters::linear, &PointParameters::quadratic})
        add_points(f, nan);
    for (const auto f : {&PointParameters::min_size, &PointParameters::max_size}) add_points(f, 0);
    add_level(&TextureLodState::max_level, -1);
    return out;
}

std::vector<std::string> refused_draws() {
    std::vector<std::string> out;
    const auto add = [&](const std::function<void(Draw&)>& f) { out.push_back(refused_draw(f)); };
    add([](Draw& d) { d.mesh = nullptr; });
    add([](Draw& d) { d.eye_from_object[0][0] = nan; });
    add([](Draw& d) { d.material.Ks.y = nan; });
    add([](Draw& d) { d.material.Ns = 10001; });
    add([](Draw& d) { d.material.alpha = nan; });
    const auto current = [&](const std::function<void(CurrentValues&)>& change) {
        CurrentValues values;
        change(values);
        add([&](Draw& d) { d.current = std::make_shared<const CurrentValues>(values); });
    };
    current([](CurrentValues& v) { v.color.x = nan; });
    current([](CurrentValues& v) { v.normal.y = infinity; });
    current([](CurrentValues& v) { v.texcoord.w = nan; });
    current([](CurrentValues& v) { v.secondary_color.z = nan; });
    current([](CurrentValues& v) { v.fog_coordinate = infinity; });
    current([](CurrentValues& v) { v.more_texcoords[2].x = nan; });
    add([](Draw& d) { d.id_shift = 32; });
    add([](Draw& d) { d.lights = std::make_shared<const std::vector<Light>>(9); });
    add([](Draw& d) { d.map.slot = 3; });
    add([](Draw& d) {
        const std::vector<std::uint16_t> texel(4);
        d.map = {make_texture("t", 1, 1, texel), 3};
    });
    const auto light = [&](const std::function<void(Light&)>& f) {
        out.push_back(refused_light(f));
    };
    light([](Light& l) { l.position.w = nan; });
    light([](Light& l) { l.Ia.x = nan; });
    light([](Light& l) { l.Id.x = nan; });
    light([](Light& l) { l.Is.x = nan; });
    light([](Light& l) { l.spot_direction.x = nan; });
    light([](Light& l) { l.spot_exponent = 129; });
    light([](Light& l) { l.spot_cos_cutoff = 2; });
    light([](Light& l) { l.quadratic_attenuation = -1; });

    SetState compare;
    compare.state.edit().texture.shadow_compare = true;
    const std::vector<std::uint16_t> texel(4);
    const Draw mapped{.mesh = a_mesh(), .map = {make_texture("t", 1, 1, texel), {}}};
    out.push_back(refusal({compare, mapped}, ideal()));
    const Draw slot{.mesh = a_mesh(), .map = {nullptr, 0}};
    out.push_back(refusal({CopyTexture{0, Plane::Color, {0, 0, 1, 1}}, compare, slot}, ideal()));
    return out;
}

std::vector<std::string> refused_pixel_commands() {
    const Rgba white{255, 255, 255, 255}, too_white{256, 0, 0, 0};
    return {
        refusal({BeginPass{"", 16}}),
        refusal({BeginPass{"", 32}}, opengl()),
        refusal({SwapBuffers{}}),
        refusal({Query{3, false}}, opengl()),
        refusal({Query{3}, Query{4}}, opengl()),
        refusal({Clear{16}}),
        refusal({Read{0, Plane(4), {0, 0, 1, 1}}}),
        refusal({Accumulate{AccumOp(5), 1}}),
        refusal({WriteSpans{{}, {too_white}, 0}}),
        refusal({WriteSpans{{}, {white}, 1u << 24}}),
        refusal({WriteSpans{{{-4097, 0, 1, 0, true}}, {white}, 0}}),
        refusal({WriteSpans{{{0, 4097, 1, 0, true}}, {white}, 0}}),
        refusal({WriteSpans{{{0, 0, -1, 0, true}}, {white}, 0}}),
        refusal({WriteSpans{{{0, 0, 2, 0, false}}, {white}, 0}}),
        refusal({WritePixels{{0, 0, 4097, 1}, Plane::Color, {}, {}, 0}}),
        refusal({WritePixels{{0, 0, 1, -1}, Plane::Color, {}, {}, 0}}),
        refusal({WritePixels{{4097, 0, 1, 1}, Plane::Color, {white}, {}, 0}}),
        refusal({WritePixels{{0, -4097, 1, 1}, Plane::Color, {white}, {}, 0}}),
        refusal({WritePixels{{0, 0, 1, 1}, Plane::Accum, {}, {0}, 0}}),
        refusal({WritePixels{{0, 0, 1, 1}, Plane::Depth, {}, {}, 0}}),
        refusal({WritePixels{{0, 0, 1, 1}, Plane::Stencil, {}, {256}, 0}}),
        refusal({Copy{Plane::Accum, {}, 0, 0}}),
        refusal({Copy{Plane::Color, {0, 0, 1, 1}, 0, 5000}}),
        refusal({Read{0, Plane::Color, {15, 0, 2, 1}}}),
        refusal({CopyTexture{256, Plane::Color, {0, 0, 1, 1}}}),
        refusal({CopyTexture{0, Plane::Stencil, {0, 0, 1, 1}}}),
        refusal({CopyTexture{0, Plane::Color, {0, 0, 3, 1}}}),
        refusal({CopyTexture{0, Plane::Color, {0, 0, 1, 0}}}),
        refusal({CopyTexture{0, Plane::Color, {0, 0, 0, 1}}}, opengl()),
        refusal({CopyTexture{0, Plane::Color, {0, 0, 3, 0}}}, opengl()),
        refusal({Read{0, Plane::Depth, {0, 0, 1, 1}, true}}),
        refusal({Read{0, Plane::Color, {0, 0, 1, 1}, true}}, reality()),
        refusal({Accumulate{AccumOp::Accum, infinity}}),
        refusal({Clear{0, {nan, 0, 0, 0}}}),
        refusal({Clear{0, {0, 0, 0, 0}, double(infinity)}}),
        refusal({Clear{.accum = {0, 0, nan, 0}}}),
    };
}

std::string refused_pixels(const std::function<void(DrawPixels&)>& change) {
    DrawPixels draw{.width = 2, .height = 1};
    change(draw);
    return refusal({draw}, opengl());
}

std::vector<std::string> refused_draw_pixels() {
    using D = DrawPixels;
    return {
        refusal({D{}}),
        refused_pixels([](D& d) { d.width = -1; }),
        refused_pixels([](D& d) { d.height = 8193; }),
        refused_pixels([](D& d) { d.raster.x = nan; }),
        refused_pixels([](D& d) { d.raster.y = infinity; }),
        refused_pixels([](D& d) { d.raster.depth = 1u << 24; }),
        refused_pixels([](D& d) { d.raster.color[3] = 256; }),
        refused_pixels([](D& d) { d.raster.texcoord.z = nan; }),
        refused_pixels([](D& d) { d.raster.more_texcoords[0].y = nan; }),
        refused_pixels([](D& d) { d.raster.distance = -1; }),
        refused_pixels([](D& d) { d.raster.distance = nan; }),
        refused_pixels([](D& d) { d.raster.fog_coordinate = infinity; }),
        refused_pixels([](D& d) { d.zoom_x = nan; }),
        refused_pixels([](D& d) { d.zoom_y = infinity; }),
        refused_pixels([](D& d) { d.colors.resize(1); }),
        refused_pixels([](D& d) { d.depths.resize(3); }),
        refused_pixels([](D& d) { d.stencils.resize(1); }),
        refused_pixels([](D& d) { d.bits.resize(2); }),
        refused_pixels([](D& d) {
            d.stencils.resize(2);
            d.colors.resize(2);
        }),
        refused_pixels([](D& d) {
            d.depths.resize(2);
            d.source = PixelSource{};
        }),
        refused_pixels([](D& d) {
            d.colors.resize(2, {256, 0, 0, 0});
        }),
        refused_pixels([](D& d) { d.depths.resize(2, 1u << 24); }),
        refused_pixels([](D& d) { d.stencils.resize(2, 256); }),
        refused_pixels([](D& d) {
            d.source = PixelSource{Plane::Accum, 0, 0};
        }),
        refused_pixels([](D& d) {
            d.source = PixelSource{Plane(7), 0, 0};
        }),
        refused_pixels([](D& d) {
            d.source = PixelSource{Plane::Color, 0, -4097};
        }),
        refused_pixels([](D& d) { d.map.slot = 3; }),
    };
}

std::vector<std::string> refused_values() {
    const std::vector<vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto mesh = [&](const std::function<void(MeshData&)>& change) {
        MeshData data{.positions = corners};
        change(data);
        return message_of([&] { make_mesh(data); });
    };
    Profile profile = vgx();
    profile.color_bits = 7;
    const std::vector<std::uint16_t> texel(4);
    return {
        message_of([&] { validate(profile); }),
        message_of([] { check_window(4097, 1); }),
        mesh([](MeshData& d) {
            d.normals = {{0, 0, 1}, {0, 0, 1}};
        }),
        mesh([](MeshData& d) { d.positions[1].y = nan; }),
        mesh([](MeshData& d) {
            d.indices = {0, 1, 3};
        }),
        mesh([](MeshData& d) {
            d.indices = {0, 1};
        }),
        mesh([](MeshData& d) { d.polygon_sizes = {3}; }),
        mesh([](MeshData& d) {
            d.primitive = Primitive::Polygons;
            d.polygon_sizes = {2};
        }),
        mesh([](MeshData& d) {
            d.primitive = Primitive::Polygons;
            d.polygon_sizes = {4};
        }),
        mesh([](MeshData& d) {
            d.indices = {0, 1, 2, 2, 1, 0};
            d.polygon_ids = {1, 2, 3};
        }),
        mesh([](MeshData& d) { d.primitive = Primitive(8); }),
        mesh([](MeshData& d) {
            d.w = {1, nan, 1};
        }),
        mesh([](MeshData& d) {
            d.materials.resize(2);
            d.material_indices = {0, 2, 0};
        }),
    };
}

// Too large for a test.
const std::set<std::string> not_tried{
    "mesh: V positions; at most 268435456",
    "mesh: V indices are too many",
    "mesh: V triangles; at most 268435456",
};

TEST(ManualRefusals, EachIsListedAndHappens) {
    std::vector<std::string> happened;
    for (const auto& some : {refused_states(), refused_draws(), refused_pixel_commands(),
                             refused_draw_pixels(), refused_values(), refused_textures(message_of),
                             test::refused_surfaces(refusal), test::refused_samples(refusal)})
        happened.insert(happened.end(), some.begin(), some.end());
    const std::vector<std::string> listed = messages_of_the_page();
    EXPECT_GE(listed.size(), 90u);
    std::vector<std::pair<std::string, std::regex>> patterns;
    for (const std::string& message : listed) patterns.emplace_back(message, pattern_of(message));
    std::set<std::string> found = not_tried;
    for (const std::string& message : happened) {
        bool is_listed = false;
        for (const auto& [candidate, pattern] : patterns)
            if (std::regex_match(message, pattern)) {
                found.insert(candidate);
                is_listed = true;
            }
        EXPECT_TRUE(is_listed) << message;
    }
    for (const std::string& message : listed)
        EXPECT_TRUE(found.contains(message)) << "does not happen: " << message;
}

TEST(ManualRefusals, ARefusedListChangesNothing) {
    const auto machine = make_reference(vgx(), 4, 4);
    CommandList list;
    list.add(Clear{all_planes, {1, 1, 1, 1}, 1, 7});
    list.add(CopyTexture{0, Plane::Color, {0, 0, 3, 1}});
    EXPECT_THROW(machine->execute(list), Error);
    EXPECT_EQ(machine->planes().color[0], (Rgba{0, 0, 0, 0}));
    EXPECT_TRUE(machine->passes().empty());
}

}  // namespace
}  // namespace gw
