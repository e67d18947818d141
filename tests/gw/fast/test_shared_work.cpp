// Values that the fast machine computes once for several draws or lists are right for each. The
// reference machine shares nothing. Does not measure the savings.
#include "tests/gw/workbench.h"

#include <algorithm>
#include <functional>

namespace gw::test {
namespace {

/// Triangles in and around the window: clipped ones, a back face, one that ends at a tile's side.
MeshRef some_triangles() {
    MeshData data = mesh_data(Primitive::Triangles, {{-20, 5, 9},
                                                     {30, 3, 9},
                                                     {17, 40, 30},
                                                     {60, 90, 5},
                                                     {22, 150, 7},
                                                     {20, 30, 8},
                                                     {9, 9, 2},
                                                     {50, 11, 3},
                                                     {64, 64, 4}});
    data.normals.assign(data.positions.size(), vec3(0.6f, 0, 0.8f));
    return make_mesh(std::move(data));
}

LightsRef lights_of(const Light& light) {
    return std::make_shared<const std::vector<Light>>(1, light);
}

TEST(SharedWork, AListMayUseTheGeometryOfTheOneBefore) {
    const Draw draw{.mesh = some_triangles(), .lights = lights_of({.position = {9, 9, 40, 1}})};
    Workbench bench(vgx(), 128, 128);
    const auto check_draw = [&](ColorSource source, JitterState jitter, double moved) {
        Draw now = draw;
        now.eye_from_object[3].x = moved;
        bench.state.color_source = source;
        bench.state.jitter = jitter;
        CommandList list;
        list.add(SetState{bench.state});
        list.add(Clear{.planes = all_planes});
        list.add(now);
        bench.run(list);
        bench.compare();
    };
    check_draw(ColorSource::PolygonId, {}, 0);
    check_draw(ColorSource::Lighting, {}, 0);      // lights the vertices for the first time
    check_draw(ColorSource::Lighting, {6, 7}, 0);  // into other tiles
    check_draw(ColorSource::PolygonId, {}, 0);
    check_draw(ColorSource::Lighting, {}, 7);
    check_draw(ColorSource::Lighting, {}, 0);
    bench.state.cull = {.enable = true, .face = Face::Front};
    check_draw(ColorSource::Lighting, {}, 0);
}

/// The number of colours, except the cleared one, after a draw in ambient light alone.
std::size_t colors_in_ambient_light(const Light& light, bool two_side) {
    Workbench bench;
    bench.clear();
    bench.state.color_source = ColorSource::Lighting;
    bench.state.lighting.two_side = two_side;
    bench.draw(Draw{.mesh = some_triangles(),
                    .material = {.Ka = vec3(0.9f, 0.5f, 0.1f), .Kd = vec3(0)},
                    .lights = lights_of(light)});
    std::vector<Rgba> colors = bench.planes().color;
    std::erase(colors, Rgba{});
    std::sort(colors.begin(), colors.end());
    return std::size_t(std::unique(colors.begin(), colors.end()) - colors.begin());
}

TEST(SharedWork, AmbientLightThatIsEvenHasOneColour) {
    const Light lamp{.position = {9, 9, 40, 1}, .Ia = vec3(0.7f)};
    Light sun = lamp, falling = lamp, spot = lamp, weak = lamp;
    sun.position.w = 0;
    weak.constant_attenuation = 3;
    falling.quadratic_attenuation = 0.001f;
    spot.spot_direction = {0, 0, -1};
    spot.spot_cos_cutoff = 0.5f;
    spot.spot_exponent = 9;
    for (const bool two_side : {false, true}) {
        for (const Light& even : {lamp, sun, weak})
            EXPECT_EQ(colors_in_ambient_light(even, two_side), 1u);
        for (const Light& uneven : {falling, spot})
            EXPECT_GT(colors_in_ambient_light(uneven, two_side), 1u);
    }
}

/// Quads side by side, every second one black at all corners. The last covers the one before.
MeshRef half_black() {
    MeshData data{.primitive = Primitive::Quads};
    for (int i = 0; i < 10; ++i) {
        const float x = 7 * float(i == 9 ? 8 : i), shade = i % 2 == 0 ? 0 : 0.7f;
        for (const vec2& corner : {vec2(0, 1), vec2(6, 0), vec2(9, 62), vec2(1, 60)}) {
            data.positions.push_back({x + corner.x, corner.y, 40});
            data.texcoords.push_back(corner / 8.0f);
            data.colors.push_back({shade, 0, shade * corner.x / 9, corner.y / 62});
        }
    }
    return make_mesh(std::move(data));
}

TEST(SharedWork, BlackMayBeLeftOutOfASum) {
    const std::vector<std::uint8_t> texels{255, 80, 0,   255, 9,  200, 90, 100,
                                           0,   0,  255, 255, 70, 70,  70, 0};
    Draw draw{.mesh = half_black()};
    const std::vector<std::function<void(State&)>> changes{
        [](State&) {},
        [](State& s) { s.color_mask.a = false; },
        [](State& s) { s.shade_model = ShadeModel::Flat; },
        [](State& s) { s.blend.src = BlendFactor::OneMinusDstColor; },
        [](State& s) { s.blend.dst = BlendFactor::SrcAlpha; },
        [](State& s) { s.blend.enable = false; },
        [](State& s) {
            s.fog = {.enable = true,
                     .mode = FogMode::Linear,
                     .start = -100,
                     .end = 90,
                     .color = vec4(0, 0, 0, 1)};
        },
        [](State& s) {
            s.fog = {.enable = true,
                     .mode = FogMode::Linear,
                     .start = -100,
                     .end = 90,
                     .color = vec4(0.3f, 0, 0.2f, 1)};
        },
        [](State& s) { s.texture.env = TexEnv::Decal; },
        [](State& s) {
            s.texture.env = TexEnv::Blend;
            s.texture.env_color = vec4(0.4f, 0.5f, 0.1f, 1);
        },
        [](State& s) {
            s.stencil.test = true;
            s.stencil.zpass = StencilOp::Incr;
        },
    };
    for (const bool textured : {false, true})
        for (const float alpha : {0.0f, 0.5f, 1.0f})
            for (const auto& change : changes) {
                Workbench bench;
                draw.map.texture = textured ? make_texture8("four", 2, 2, texels) : nullptr;
                CommandList list;
                State state = bench.state;
                state.color_source = ColorSource::Vertex;
                state.color_mask = {false, false, false, false};
                state.depth.test = true;
                list.add(SetState{state});
                list.add(Clear{.planes = all_planes, .color = vec4(0.1f, 0.2f, 0.3f, alpha)});
                list.add(draw);
                state.color_mask = {};
                state.depth = {true, DepthFunc::Equal, false};
                state.blend = {true, BlendFactor::One, BlendFactor::One};
                change(state);
                list.add(SetState{state});
                for (int pass = 0; pass < 3; ++pass) list.add(draw);
                bench.run(list);
            }
}

/// A triangle of a mesh that has many more vertices.
MeshRef triangle_among(std::size_t vertices) {
    MeshData data = mesh_data(Primitive::Triangles, {{0, 0, 9}, {8, 0, 9}, {0, 8, 9}});
    data.positions.resize(vertices);
    data.indices = {0, 1, 2};
    return make_mesh(std::move(data));
}

TEST(SharedWork, AListMayHaveMoreVerticesThanASegment) {
    Workbench bench;
    bench.clear();
    bench.state.blend = {.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
    const MeshRef mesh = triangle_among(4000);
    CommandList list;
    for (const DepthFunc func : {DepthFunc::Less, DepthFunc::Equal}) {
        bench.state.depth = {.test = true, .func = func, .mask = func == DepthFunc::Less};
        list.add(SetState{bench.state});
        const int step = func == DepthFunc::Less ? 1 : 10;
        for (int i = 0; i < 1100; i += step) {
            Draw draw{.mesh = mesh};
            draw.eye_from_object[3] = {i % 61, i % 53, i % 17, 1};
            list.add(draw);
        }
    }
    bench.run(list);
    EXPECT_EQ(bench.take_counters().draws, 1210u);
}

/// Only so many are kept ready for the filter.
TEST(SharedWork, ATextureMayHaveManyBorderColors) {
    MeshData data = mesh_data(Primitive::Quads, {{0, 0, 1}, {12, 0, 1}, {12, 12, 1}, {0, 12, 1}});
    data.texcoords = {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}};
    Draw draw{.mesh = make_mesh(std::move(data))};
    draw.map.texture =
        make_texture8("t", 2, 1, std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 255, 255});
    Workbench bench(opengl(), 256, 64);
    bench.clear();
    TextureState& t = bench.state.texture;
    t.env = TexEnv::Replace;
    for (int i = 0; i < 60; ++i) {
        t.border_color = vec4(float(i % 20) / 19, 1, 0, 1);
        t.wrap_s = i % 3 == 0 ? Wrap::Repeat : Wrap::BorderClamp;
        t.wrap_t = i % 3 == 1 ? Wrap::Clamp : Wrap::BorderClamp;
        draw.eye_from_object[3] = {double(i % 20) * 12, double(i / 20) * 16, 0, 1};
        bench.draw(draw);
    }
    EXPECT_EQ(bench.color(0, 0)[0], 0);
    EXPECT_GT(bench.color(19 * 12, 0)[0], 100);
}

}  // namespace
}  // namespace gw::test
