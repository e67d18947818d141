// docs/manual/geometry.md: the worked examples.
#include "gw/stages/clip.h"
#include "gw/stages/fan.h"
#include "gw/stages/window.h"
#include "tests/gw/workbench.h"

namespace gw {
namespace {

using test::Workbench;

// [R6.7]
TEST(ManualGeometry, FillOutlineAndCorners) {
    const std::vector<vec3> quad{
        {8.5f, 8.5f, 0}, {24.5f, 8.5f, 0}, {24.5f, 24.5f, 0}, {8.5f, 24.5f, 0}};
    const std::array<std::pair<PolygonMode, std::uint64_t>, 3> modes{
        {{PolygonMode::Fill, 256}, {PolygonMode::Line, 64}, {PolygonMode::Point, 4}}};
    for (const auto& [mode, fragments] : modes) {
        Workbench bench;
        bench.state.polygon_mode = mode;
        bench.draw(Primitive::Quads, quad);
        EXPECT_EQ(bench.take_counters().fragments, fragments);
    }
}

// [R6.3]
TEST(ManualGeometry, AConcavePolygon) {
    Workbench bench;
    bench.draw(Primitive::Polygons, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}});
    EXPECT_EQ(bench.take_counters().fragments, 12u);
    EXPECT_EQ(bench.color(1, 3)[3], 0);
    // on the right side of the notch, which is a left side of the polygon
    EXPECT_EQ(bench.color(2, 2)[3], 255);
    EXPECT_EQ(bench.color(1, 2)[3], 0);
}

// [R6.2] [R6.6]
TEST(ManualGeometry, FlatFacesHaveTheirOwnVertexColour) {
    const auto flat = [](Primitive primitive, std::vector<vec3> p, int x, int y) {
        Workbench bench;
        bench.state.shade_model = ShadeModel::Flat;
        std::vector<vec4> colors;
        for (std::size_t i = 0; i < p.size(); ++i)
            colors.push_back(vec4(float(i + 1) / 255, 0, 0, 1));
        bench.draw(primitive, std::move(p), std::move(colors));
        return int(bench.color(x, y)[0]);
    };
    const std::vector<vec3> square{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
    const std::vector<vec3> zigzag{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 0}};
    EXPECT_EQ(flat(Primitive::Triangles, {square[0], square[1], square[2]}, 6, 1), 3);
    EXPECT_EQ(flat(Primitive::TriangleStrip, zigzag, 1, 1), 3);
    EXPECT_EQ(flat(Primitive::TriangleStrip, zigzag, 6, 6), 4);
    EXPECT_EQ(flat(Primitive::TriangleFan, square, 6, 1), 3);
    EXPECT_EQ(flat(Primitive::TriangleFan, square, 1, 6), 4);
    EXPECT_EQ(flat(Primitive::Quads, square, 6, 1), 4);
    EXPECT_EQ(flat(Primitive::Polygons, square, 1, 6), 1);
    EXPECT_EQ(flat(Primitive::Lines, {{0, 1.5f, 0}, {8, 1.5f, 0}}, 3, 1), 2);
    EXPECT_EQ(flat(Primitive::Points, {{3, 3, 0}}, 3, 3), 1);
}

/// glFrustum(-1, 1, -1, 1, 1, 9).
dmat4 frustum() {
    dmat4 m(0);
    m[0][0] = m[1][1] = 1;
    m[2] = {0, 0, -1.25, -1};
    m[3] = {0, 0, -2.25, 0};
    return m;
}

// [R6.9] [R6.20] [R6.21]
TEST(ManualGeometry, AVertexGoesToTheWindow) {
    State state;
    state.projection = frustum();
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{1, 2, 0}}))};
    draw.eye_from_object[3] = {0, 0, -4, 1};
    const Profile profile = vgx();
    const Vertex v = run_vertex(vertex_program(state, draw, profile), 0);
    EXPECT_EQ(v.clip, dvec4(1, 2, 2.75, 4));
    const WindowVertex w = to_window(v, {32, 32, 32, 32}, {}, profile);
    EXPECT_EQ(w.x, 320);
    EXPECT_EQ(w.y, 384);
    EXPECT_EQ(w.z, 14155775u);
    EXPECT_EQ(w.w, 4);
}

// [R6.11]
TEST(ManualGeometry, NormalsGoByTheInverseTranspose) {
    // Scaled by 2 along x, a normal (1, 1, 0) becomes (1, 2, 0) / sqrt 5. A mirror turns the normal
    // with the surface.
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0, 0, 0}}))};
    State state;
    state.color_source = ColorSource::Lighting;
    const auto red = [&](const dmat4& m, const vec3& light) {
        MeshData data = test::mesh_data(Primitive::Points, {{0, 0, 0}});
        data.normals = {{1, 1, 0}};
        draw.mesh = make_mesh(data);
        draw.eye_from_object = m;
        draw.material = {.Ka = vec3(0), .Kd = vec3(1)};
        draw.lights =
            std::make_shared<const std::vector<Light>>(1, Light{.position = vec4(light, 0)});
        const Profile profile = vgx();
        return run_vertex(vertex_program(state, draw, profile), 0).color[0];
    };
    dmat4 scale(1), mirror(1);
    scale[0][0] = 2;
    mirror[0][0] = -1;
    EXPECT_EQ(red(scale, {1, 0, 0}), 114);    // 255 / sqrt 5 = 114.04
    EXPECT_EQ(red(scale, {0, 1, 0}), 228);    // 2 * 255 / sqrt 5 = 228.08
    EXPECT_EQ(red(mirror, {-1, 0, 0}), 180);  // 255 / sqrt 2 = 180.3
    EXPECT_EQ(red(mirror, {1, 0, 0}), 0);
}

// [R6.9] [R6.27]
TEST(ManualGeometry, PositionsHaveAnyW) {
    // (8, 4, 0, 2) is the point (4, 2, 0); a vertex of w = 0 is a direction, here to the right.
    Workbench bench(opengl(), 16, 16);
    MeshData data = test::mesh_data(Primitive::Points, {{9, 5, 0}, {1, 1, 0}});
    data.w = {2, -1};
    bench.draw(data);
    EXPECT_EQ(bench.color(4, 2)[3], 255);
    EXPECT_EQ(bench.take_counters().rejected, 1u);  // w < 0 lies behind the eye
    MeshData shadow = test::mesh_data(Primitive::Triangles, {{2, 2, 0}, {1, 0, 0}, {2, 6, 0}});
    shadow.w = {1, 0, 1};
    bench.draw(shadow);
    EXPECT_EQ(bench.color(15, 3)[3], 255);
    EXPECT_EQ(bench.color(1, 3)[3], 0);
}

// [R6.28]
TEST(ManualGeometry, NormalsThatAreNotNormalised) {
    State state;
    state.color_source = ColorSource::Lighting;
    MeshData data = test::mesh_data(Primitive::Points, {{0, 0, 0}});
    data.normals = {{0, 0, 0.5f}};
    Draw draw{.mesh = make_mesh(data)};
    draw.material = {.Ka = vec3(0), .Kd = vec3(1)};
    draw.lights = std::make_shared<const std::vector<Light>>(1, Light{});
    const auto red = [&](double scale) {
        draw.eye_from_object = dmat4(scale);
        draw.eye_from_object[3][3] = 1;
        const Profile profile = opengl();
        return run_vertex(vertex_program(state, draw, profile), 0).color[0];
    };
    EXPECT_EQ(red(1), 255);
    state.normalize = false;
    EXPECT_EQ(red(1), 128);  // 127.5, to even
    EXPECT_EQ(red(2), 64);   // an object twice as large has normals half as long
    EXPECT_EQ(red(0), 0);
}

// [R6.29]
TEST(ManualGeometry, EdgeFlagsLeaveSidesOut) {
    MeshData data = test::mesh_data(Primitive::Quads, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    data.edge_flags = {1, 0, 1, 1};
    const MeshRef mesh = make_mesh(data);
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->triangles()[0].edges, 1);  // (0,1); not (1,2), not the diagonal
    EXPECT_EQ(mesh->triangles()[1].edges, 6);  // (2,3), (3,0)
}

// [R6.30]
TEST(ManualGeometry, FacesHaveModesOfTheirOwn) {
    Workbench bench(opengl(), 16, 16);
    bench.state.polygon_mode = PolygonMode::Line;
    bench.state.two_side_polygon_mode = true;
    const std::vector<vec3> square{{1, 1, 0}, {9, 1, 0}, {9, 9, 0}, {1, 9, 0}};
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.take_counters().fragments, 32u);
    bench.state.cull.front = Winding::CW;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.take_counters().fragments, 64u);
    bench.state.back_polygon_mode = PolygonMode::Point;
    bench.draw(Primitive::Quads, square);
    EXPECT_EQ(bench.take_counters().fragments, 4u);
}

// [R5.9]
TEST(ManualGeometry, CurrentValuesStandForWhatTheMeshLacks) {
    Workbench bench(opengl(), 4, 4);
    Draw draw{.mesh = make_mesh(test::mesh_data(Primitive::Points, {{0.5f, 0.5f, 0}}))};
    CurrentValues values;
    values.color = {0.5f, 0, 1, 1};
    draw.current = std::make_shared<const CurrentValues>(values);
    bench.draw(draw);
    EXPECT_EQ(bench.color(0, 0), (Rgba{128, 0, 255, 255}));
}

// [R6.16] [R6.17] [R6.18]
TEST(ManualGeometry, ANewVertexStartsFromTheInside) {
    Vertex in, out;
    in.clip = {0, 0, 1, 2};
    out.clip = {0, 0, -3, 2};
    in.color[0] = 255;
    const ViewportTransform viewport{32, 32, 32, 32};
    for (const auto& [a, b] : {std::pair(in, out), std::pair(out, in)}) {
        const Clipped clipped = clip({a, b}, viewport);
        ASSERT_EQ(clipped.vertices.size(), 2u);
        const Vertex& added = clipped.vertices[a.clip.z > 0 ? 1 : 0];
        EXPECT_EQ(added.clip, dvec4(0, 0, -2, 2));
        EXPECT_EQ(added.color[0], 64);
        EXPECT_TRUE(clipped.cut);
    }
}

/// The triangle of the page: near plane first, then user plane 0, then nothing.
// [R6.10] [R6.16] [R6.17] [R6.18] [R11.5]
TEST(ManualGeometry, ATriangleCutTwice) {
    const std::array<dvec4, 3> position{{{0, 0, -3, 1}, {4, 0, 1, 1}, {0, 4, 1, 1}}};
    const std::array<double, 3> red{255, 10, 0}, fog{255, 94, 191};
    std::vector<Vertex> corners(3);
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].clip = position[i];
        corners[i].distance[0] = dot4({-1, 0, 0, 1}, position[i]);
        corners[i].color[0] = red[i];
        corners[i].fog = fog[i];
    }
    const Clipped clipped = clip(corners, {32, 32, 32, 32});
    EXPECT_TRUE(clipped.cut);
    const std::array<dvec4, 4> left{{{1, 3, 1, 1}, {0, 4, 1, 1}, {0, 2, -1, 1}, {1, 1, -1, 1}}};
    const std::array<double, 4> left_red{2, 0, 128, 130}, left_fog{166.75, 191, 223, 198.75};
    ASSERT_EQ(clipped.vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(clipped.vertices[i].clip, left[i]);
        EXPECT_EQ(clipped.vertices[i].color[0], left_red[i]);
        EXPECT_EQ(clipped.vertices[i].fog, left_fog[i]);
    }
}

/// Jitter moves coverage, and neither facing nor pieces.
// [R6.22]
TEST(ManualGeometry, JitterMovesPixelsByWholeUnits) {
    const auto pixels = [](int x, int y) {
        Workbench bench(vgx(), 16, 16);
        bench.state.jitter = {x, y};
        bench.draw(Primitive::Quads,
                   {{2.5f, 2.5f, 0}, {4.5f, 2.5f, 0}, {4.5f, 4.5f, 0}, {2.5f, 4.5f, 0}});
        std::vector<std::array<int, 2>> out;
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                if (bench.color(i, j)[3] != 0) out.push_back({i, j});
        return out;
    };
    using Pixels = std::vector<std::array<int, 2>>;
    EXPECT_EQ(pixels(0, 0), (Pixels{{2, 3}, {3, 3}, {2, 4}, {3, 4}}));
    EXPECT_EQ(pixels(1, 0), (Pixels{{3, 3}, {4, 3}, {3, 4}, {4, 4}}));
    EXPECT_EQ(pixels(0, -1), (Pixels{{2, 2}, {3, 2}, {2, 3}, {3, 3}}));
}

/// Vertex colours are quantized; without colours they are white; lines take them from their ends.
// [R6.8] [R6.12]
TEST(ManualGeometry, VertexColoursAreQuantized) {
    Workbench bench;
    bench.draw(Primitive::Points, {{3.5f, 3.5f, 0}, {5.5f, 5.5f, 0}},
               {{0.5f, 0.25f, -1, 1}, {2, 0, 0, 0.5f}});
    EXPECT_EQ(bench.color(3, 3), (Rgba{128, 64, 0, 255}));
    EXPECT_EQ(bench.color(5, 5), (Rgba{255, 0, 0, 128}));
    EXPECT_EQ(bench.take_counters().vertices, 2u);
    bench.draw(Primitive::Points, {{7.5f, 7.5f, 0}});
    EXPECT_EQ(bench.color(7, 7), (Rgba{255, 255, 255, 255}));
}

// [R6.25]
TEST(ManualGeometry, AFanStartsWhereNoPieceIsTurnedOver) {
    const std::vector<SnappedPoint> corners{{80, 80}, {160, 80}, {160, 160}, {120, 119}};
    const Fan fan = fan_of(corners);
    EXPECT_EQ(fan.area2, 6320);
    EXPECT_EQ(fan.first, 1u);
    std::vector<SnappedPoint> mirrored;
    for (const SnappedPoint& p : corners) mirrored.push_back({-p[0], p[1]});
    EXPECT_EQ(fan_of(mirrored).area2, -6320);
    EXPECT_EQ(fan_of(mirrored).first, 1u);
}

// [R6.23] [R6.24]
TEST(ManualGeometry, FacingIsOfTheSnappedPolygon) {
    const std::vector<vec3> ccw{{8, 8, 0}, {24, 8, 0}, {24, 24, 0}},
        cw{{8, 8, 0}, {24, 24, 0}, {24, 8, 0}};
    const std::vector<vec3> flat{
        {8, 8, 0}, {24, 8.03125f, 0}, {40, 8, 0}};  // a quarter unit high: snapped away
    for (const bool cull : {false, true})
        for (const Winding front : {Winding::CW, Winding::CCW}) {
            Workbench bench;
            bench.state.cull = {cull, Face::Back, front};
            bench.draw(Primitive::Triangles, ccw);
            EXPECT_EQ(bench.take_counters().drawn, cull && front == Winding::CW ? 0u : 1u);
            bench.draw(Primitive::Triangles, cw);
            EXPECT_EQ(bench.take_counters().drawn, cull && front == Winding::CCW ? 0u : 1u);
            bench.draw(Primitive::Triangles, flat);
            const Counters c = bench.take_counters();
            EXPECT_EQ(c.degenerate, 1u);
            EXPECT_EQ(c.drawn + c.culled, 0u);
        }
}

// [R6.31] [R6.32]
TEST(ManualGeometry, ClipControl) {
    const ClipPosition v{{1, 2, 2.75, 4}};
    const WindowVertex at = to_window(v, {32, -32, 32, 32, true}, {}, vgx());
    EXPECT_EQ(at.x, 320);
    EXPECT_EQ(at.y, 128);
    EXPECT_EQ(at.z, 11534335u);
    State state;
    state.clip_control = {ClipOrigin::UpperLeft, ClipDepth::ZeroToOne};
    const ViewportTransform viewport = resolve(state, opengl(), 64, 64).viewport;
    EXPECT_EQ(viewport.half_height, -32);
    EXPECT_EQ(viewport.center_y, 32);
    EXPECT_EQ(clip_distance(v, 0, viewport), 2.75);
    EXPECT_EQ(clip_distance(v, 10, viewport), -32 * 2 + (32 + 6144) * 4);
}

// [R6.31] The picture is upside down, but a front face stays one.
TEST(ManualGeometry, TheOriginAboveKeepsFacing) {
    test::Workbench bench(opengl(), 8, 8);
    bench.state.clip_control.origin = ClipOrigin::UpperLeft;
    bench.state.cull = {.enable = true, .face = Face::Back};
    bench.draw(Primitive::Quads, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    EXPECT_EQ(bench.color(0, 7)[0], 255);
    EXPECT_EQ(bench.color(1, 6)[0], 255);
    EXPECT_EQ(bench.color(0, 0)[0], 0);
    bench.state.cull.face = Face::Front;
    EXPECT_EQ((bench.take_counters(), 0), 0);
    bench.draw(Primitive::Quads, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    EXPECT_EQ(bench.take_counters().culled, 2u);
}

// [R6.32]
TEST(ManualGeometry, DepthsFromZeroToOne) {
    test::Workbench bench(opengl(), 8, 8);
    bench.state.clip_control.depth = ClipDepth::ZeroToOne;
    bench.state.projection[2].z = 1;
    bench.state.projection[3].z = 0;
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    const auto square = [&](float z) {
        bench.draw(Primitive::Quads, {{0, 0, z}, {4, 0, z}, {4, 4, z}, {0, 4, z}});
    };
    square(0.25f);
    EXPECT_EQ(bench.depth(1, 1), 4194304u);  // rne(4194303.75)
    bench.state.depth_range = {1, 0};
    square(0.25f);
    EXPECT_EQ(bench.depth(1, 1), 12582911u);  // 12582911.25
    bench.take_counters();
    square(-0.25f);
    EXPECT_EQ(bench.take_counters().rejected, 2u);
}

// [R1.4]
TEST(ManualGeometry, ClipControlIsAnExtension) {
    for (const bool depth : {false, true}) {
        test::Workbench bench(ideal(), 4, 4);
        if (depth)
            bench.state.clip_control.depth = ClipDepth::ZeroToOne;
        else
            bench.state.clip_control.origin = ClipOrigin::UpperLeft;
        EXPECT_EQ(test::error_of([&] { bench.clear(); }),
                  "command 0 (SetState): extension clip_control is not in profile ideal");
    }
}

}  // namespace
}  // namespace gw
