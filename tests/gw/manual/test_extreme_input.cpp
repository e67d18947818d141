// Invalid and extreme input: it is refused with a message, or it has a defined result, the same on
// both machines. docs/manual/differences.md, "Invalid and extreme input".
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <cmath>
#include <limits>

namespace gw {
namespace {

using namespace test;

constexpr float largest = std::numeric_limits<float>::max(),
                denormal = std::numeric_limits<float>::denorm_min();

const std::vector<vec3> square{{2, 2, 0}, {14, 2, 0}, {14, 14, 0}, {2, 14, 0}};
Draw drawn(std::vector<vec3> positions, Primitive primitive = Primitive::Quads) {
    return {.mesh = make_mesh(mesh_data(primitive, std::move(positions)))};
}

// [R6.19]
TEST(ExtremeInput, ZeroWIsRejected) {
    Workbench bench(vgx(), 16, 16);
    bench.state.projection = dmat4(0);
    bench.draw(drawn(square));
    EXPECT_EQ(bench.take_counters().rejected, 2u);
    // w = z: corners with w = 0 and z = 0 pass near and far, and are not divided.
    bench.state.projection = window_projection(vgx(), 16, 16);
    bench.state.projection[2] = {0, 0, 1, 1};
    bench.state.projection[3] = {0, 0, 0, 0};
    bench.draw(drawn({{0, 0, 0}, {1, 0, 5}, {0, 1, 5}}, Primitive::Triangles));
    EXPECT_EQ(bench.take_counters().rejected, 1u);
}

// [R6.15]
TEST(ExtremeInput, CoordinatesTooLargeForClipCoordinatesReject) {
    Workbench bench(vgx(), 16, 16);
    bench.state.projection[0][0] = 1e300;
    bench.draw(drawn({{largest, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Primitive::Triangles));
    EXPECT_EQ(bench.take_counters().rejected, 1u);
    EXPECT_EQ(bench.planes(), Planes(16, 16));
}

TEST(ExtremeInput, AHugeTriangleCoversTheWindow) {
    const auto fragments = [](float size) {
        Workbench bench(vgx(), 16, 16);
        bench.draw(
            drawn({{-size, -size, 0}, {size, -size, 0}, {0, size, 0}}, Primitive::Triangles));
        return bench.take_counters().fragments;
    };
    for (const float size : {1e5f, 1e6f, 1e9f, 1e12f}) EXPECT_EQ(fragments(size), 256u) << size;
    // Farther out the error of a new vertex, of 53 bits, exceeds the window. The result is defined,
    // but is not the triangle.
    for (const float size : {1e20f, largest}) EXPECT_EQ(fragments(size), 128u) << size;
}

// [R2.1]
TEST(ExtremeInput, DenormalsAreKept) {
    Workbench bench(vgx(), 16, 16);
    bench.state.projection[0][0] = bench.state.projection[1][1] = 1 / double(denormal);
    bench.state.projection[3] = {0, 0, -1, 1};
    bench.draw(drawn({{-denormal, -denormal, 0},
                      {denormal, -denormal, 0},
                      {denormal, denormal, 0},
                      {-denormal, denormal, 0}}));
    EXPECT_EQ(bench.take_counters().fragments, 256u);
}

// [R6.23] [R9.3]
TEST(ExtremeInput, DegenerateShapesAreCountedAndDrawNothing) {
    Workbench bench(vgx(), 16, 16);
    bench.draw(drawn({{3, 3, 0}, {3, 3, 0}, {3, 3, 0}, {3, 3, 0}}));
    bench.draw(drawn({{1, 1, 0}, {5, 5, 0}, {9, 9, 0}}, Primitive::Triangles));
    bench.draw(drawn({{4, 4, 0}, {4.03f, 4.03f, 0}}, Primitive::Lines));
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.degenerate, 4u);
    EXPECT_EQ(c.fragments, 0u);
}

TEST(ExtremeInput, APolygonOf100000Corners) {
    // A comb of 50000 teeth with a flat top. Each pixel of its upper half is drawn once.
    constexpr int teeth = 49999;
    std::vector<vec3> corners{{60, 40, 0}, {4, 40, 0}};
    for (int i = 0; i <= 2 * teeth; ++i)
        corners.push_back({4 + 56 * float(i) / (2 * teeth), i % 2 == 0 ? 10.0f : 20.0f, 0});
    Workbench bench(vgx(), 64, 64);
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    MeshData data = mesh_data(Primitive::Polygons, corners);
    data.colors.assign(corners.size(), vec4(1 / 255.0f));
    bench.draw(Draw{.mesh = make_mesh(data)});
    for (int y = 20; y < 40; ++y)
        for (int x = 4; x < 60; ++x) ASSERT_EQ(bench.color(x, y)[0], 1) << x << " " << y;
    EXPECT_EQ(bench.color(3, 30)[0] + bench.color(60, 30)[0] + bench.color(30, 40)[0] +
                  bench.color(30, 9)[0],
              0);
    EXPECT_EQ(bench.take_counters().primitives, corners.size() - 2);
}

TEST(ExtremeInput, TexturesOf1x1And1x4096) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 4096), std::pair(4096, 1)}) {
        const int n = width * height;
        std::vector<std::uint8_t> texels;
        for (int i = 0; i < n; ++i)
            for (const int c : {i * 255 / std::max(1, n - 1), 10, 20, 255})
                texels.push_back(static_cast<std::uint8_t>(c));
        const TextureRef texture = make_texture8("thin", width, height, texels);
        for (int min = 0; min < 6; ++min)
            for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
                Workbench bench(vgx(), 16, 16);
                MeshData data =
                    mesh_data(Primitive::Quads, {{0, 0, 0}, {16, 0, 0}, {16, 16, 0}, {0, 16, 0}});
                data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                Draw draw{.mesh = make_mesh(data)};
                draw.map.texture = texture;
                bench.state.texture.min_filter = MinFilter(min);
                bench.state.texture.mag_filter = MagFilter(min % 2);
                bench.state.texture.wrap_s = bench.state.texture.wrap_t = wrap;
                bench.draw(draw);
                for (const int k : {2, 8, 13}) {
                    const int expected = n == 1 ? 0 : (2 * k + 1) * 255 / 32;
                    const Rgba c = width > 1 ? bench.color(k, 5) : bench.color(5, k);
                    EXPECT_NEAR(c[0], expected, 1) << width << "x" << height << " filter " << min;
                    EXPECT_EQ(c[1], 10);
                }
            }
    }
    EXPECT_EQ(error_of([] { make_texture8("long", 1, 4097, std::vector<std::uint8_t>(4 * 4097)); }),
              "texture long: 1x4097 texels; expected sides of 1 to 4096");
}

/// An ordinary or a special number.
float nasty_float(Random& random) {
    constexpr float specials[] = {0,        -0.0f,  1,     -1,     denormal, -denormal, largest,
                                  -largest, 1e-20f, 1e20f, -1e20f, 1e-38f,   65536,     0.5f};
    if (random.one_in(4)) return specials[random.between(0, int(std::size(specials)) - 1)];
    return (random.fraction() - 0.5f) * 40;
}
vec3 nasty_vec3(Random& random) {
    return {nasty_float(random), nasty_float(random), nasty_float(random)};
}
vec4 nasty_vec4(Random& random) { return {nasty_vec3(random), nasty_float(random)}; }

MeshData nasty_mesh(Random& random) {
    MeshData data{.primitive = Primitive(random.between(0, 7))};
    for (int i = 0; i < 12; ++i) {
        const auto in_window = [&] { return float(random.between(-8, 40)) / 2; };
        data.positions.push_back(random.one_in(3)
                                     ? nasty_vec3(random)
                                     : vec3(in_window(), in_window(), nasty_float(random)));
        data.normals.push_back(nasty_vec3(random));
        data.texcoords.push_back({nasty_float(random), nasty_float(random)});
        data.colors.push_back(nasty_vec4(random));
    }
    return data;
}

State nasty_state(Random& random, State s) {
    const auto number = [&] { return nasty_float(random); };
    for (int i = 0; i < 3; ++i)
        if (random.one_in(3))
            s.projection[int(random.between(0, 3))][int(random.between(0, 3))] = number();
    s.depth_range = {double(number()), double(number())};
    if (random.one_in(2)) s.clip_planes[1] = {true, dvec4(nasty_vec4(random))};
    s.polygon_mode = PolygonMode(random.one_in(3) ? random.between(0, 1) : 2);
    s.polygon_offset = {random.one_in(2), number(), number()};
    s.point_size = int(random.between(1, 5));
    s.color_source = ColorSource(random.between(0, 1));
    s.lighting = {random.one_in(2), random.one_in(2), nasty_vec4(random)};
    s.fog = {random.one_in(2),
             FogMode(random.between(0, 2)),
             std::abs(number()) + denormal,
             0,
             number(),
             nasty_vec4(random),
             FogCoordinate(random.between(0, 2))};
    if (s.fog.end == 0) s.fog.end = 1;
    TextureState& t = s.texture;
    t.min_filter = MinFilter(random.between(0, 5));
    t.wrap_s = Wrap(random.between(0, 1));
    t.wrap_t = Wrap(random.between(0, 1));
    t.gen = TexGen(random.between(0, 3));
    t.eta = number();
    for (int i = 0; i < 4; ++i) t.eye_linear[i] = dvec4(nasty_vec4(random));
    s.depth.test = random.one_in(2);
    return s;
}

Draw nasty_draw(Random& random) {
    Draw draw{.mesh = make_mesh(nasty_mesh(random))};
    if (random.one_in(2))
        for (int c = 0; c < 4; ++c)
            draw.eye_from_object[c] = dvec4(dvec3(nasty_vec3(random)), c == 3 ? 1 : 0);
    draw.material = {nasty_vec3(random), nasty_vec3(random),        nasty_vec3(random),
                     nasty_vec3(random), random.fraction() * 10000, nasty_float(random)};
    draw.lights = std::make_shared<const std::vector<Light>>(
        1,
        Light{nasty_vec4(random), nasty_vec3(random), nasty_vec3(random), nasty_vec3(random),
              nasty_vec3(random), 3, random.fraction(), random.fraction(), 0, random.fraction()});
    if (random.one_in(2))
        draw.map.texture =
            make_texture8("one", 2, 1, std::vector<std::uint8_t>{1, 2, 3, 4, 200, 100, 50, 25});
    return draw;
}

// [R5.7]
TEST(ExtremeInput, ExtremeNumbersEverywhereGiveTheSameBitsOnBothMachines) {
    std::uint64_t fragments = 0;
    for (int i = 0; i < 3000 && !HasFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "case " << i);
        Random random(std::uint64_t(i) + 40000);
        Workbench bench(ideal(), 16, 16);
        bench.state = nasty_state(random, bench.state);
        bench.draw(nasty_draw(random));
        fragments += bench.take_counters().fragments;
    }
    EXPECT_GT(fragments, 10000u);
    RecordProperty("fragments", int(fragments));
}

}  // namespace
}  // namespace gw
