// docs/manual/surfaces.md: surfaces, their planes as textures, and blits. On both machines.
#include "tests/gw/workbench.h"

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace gw {
namespace {

using test::Workbench;

constexpr PlaneMask color_plane = mask_of(Plane::Color), depth_plane = mask_of(Plane::Depth),
                    stencil_plane = mask_of(Plane::Stencil);

/// What Read gives of the surface in use.
Readback read(Workbench& bench, Plane plane, const Rect& rect) {
    bench.run(Read{7, plane, rect});
    return bench.readbacks().at(7);
}
std::vector<int> reds(Workbench& bench, const Rect& rect) {
    std::vector<int> out;
    for (const Rgba& color : read(bench, Plane::Color, rect).color) out.push_back(color[0]);
    return out;
}
using Words = CacheAlignedVector<std::uint32_t>;

/// A surface of these reds, from the bottom; it is in use afterwards.
void make_reds(Workbench& bench, std::uint32_t number, int width, int height,
               const std::vector<int>& values) {
    bench.run(MakeSurface{number, {width, height, color_plane}});
    bench.run(UseSurface{number});
    std::vector<Rgba> colors;
    for (const int v : values) colors.push_back({std::uint16_t(v), 0, 0, 255});
    bench.run(WritePixels{{0, 0, width, height}, Plane::Color, colors, {}, 0});
}

/// A square of clip coordinates -1 .. 1 at this z, textured from 0 to 1.
MeshData whole_square(float z) {
    MeshData data =
        test::mesh_data(Primitive::Quads, {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return data;
}

// [R16.1] [R16.3] [R16.6]
TEST(ManualSurfaces, ADepthPlaneOfItsOwn) {
    Workbench bench(opengl(), 8, 8);
    bench.state.projection = dmat4(1);
    bench.run(MakeSurface{3, {4, 2, depth_plane, 32}});
    bench.run(UseSurface{3});
    bench.take_counters();
    bench.clear(color_plane | depth_plane, vec4(1), 1);
    EXPECT_EQ(bench.take_counters().pixels, 8u);
    bench.state.depth = {.test = true, .func = DepthFunc::Less};
    bench.state.stencil = {.test = true, .func = StencilFunc::Never};  // there is no stencil plane
    bench.draw(whole_square(0));
    const Counters drawn = bench.take_counters();
    EXPECT_EQ(drawn.written, 8u);
    EXPECT_EQ(drawn.bytes, 8u * (4 + 4));  // depths read and written; no colour
    EXPECT_EQ(read(bench, Plane::Depth, {0, 0, 4, 2}).values, Words(8, 2147483648u));
    bench.run(UseSurface{0});
    EXPECT_EQ(bench.depth(1, 1), 0u);
    EXPECT_EQ(bench.color(1, 1), Rgba{});
}

// [R16.6]
TEST(ManualSurfaces, AUnitOfTheOffsetIsOneOfTheSurface) {
    for (const int bits : {16, 24, 32}) {
        Workbench bench(opengl(), 8, 8);
        bench.state.projection = dmat4(1);
        bench.run(MakeSurface{1, {2, 2, depth_plane, bits}});
        bench.run(UseSurface{1});
        bench.state.depth = {.test = true, .func = DepthFunc::Always};
        bench.state.depth_range = {0.25, 0.25};
        bench.state.polygon_offset = {.enable = true, .units = 3};
        bench.draw(whole_square(0));
        const double one = double((std::uint64_t{1} << bits) - 1);
        EXPECT_EQ(read(bench, Plane::Depth, {0, 0, 1, 1}).values[0],
                  std::uint32_t(std::nearbyint(0.25 * one)) + 3);
    }
}

// [R16.1]
TEST(ManualSurfaces, AreMadeOfZerosAndAnewUnderTheirNumber) {
    Workbench bench(opengl(), 8, 8);
    make_reds(bench, 1, 2, 1, {9, 8});
    bench.run(UseSurface{0});
    bench.run(MakeSurface{1, {3, 1, color_plane}});
    bench.run(UseSurface{1});
    EXPECT_EQ(reds(bench, {0, 0, 3, 1}), (std::vector{0, 0, 0}));
    bench.run(UseSurface{0});
    bench.run(MakeSurface{1, {0, 0, 0}});
    EXPECT_THROW(bench.run(UseSurface{1}), Error);
}

// [R16.2] A list goes on where the one before ended; the viewport is the surface.
TEST(ManualSurfaces, StayInUseOverLists) {
    Workbench bench(opengl(), 8, 8);
    bench.state.projection = dmat4(1);
    bench.state.color_mask = {true, false, false, true};
    bench.run(MakeSurface{2, {40, 30, surface_planes}});
    bench.run(UseSurface{2});
    bench.draw(whole_square(0));
    EXPECT_EQ(bench.take_counters().fragments, 1200u);
    EXPECT_EQ(reds(bench, {39, 29, 1, 1}), std::vector{255});
    bench.run(UseSurface{0});
    EXPECT_EQ(bench.color(0, 0), Rgba{});
    bench.draw(whole_square(0));
    EXPECT_EQ(bench.take_counters().fragments, 64u);
}

// [R16.3]
TEST(ManualSurfaces, HaveOneColourPlaneForEveryBufferButNone) {
    for (const DrawBuffer buffer :
         {DrawBuffer::None, DrawBuffer::Front, DrawBuffer::Back, DrawBuffer::FrontAndBack}) {
        Workbench bench(opengl(), 8, 8);
        bench.run(MakeSurface{1, {1, 1, color_plane}});
        bench.run(UseSurface{1});
        bench.state.draw_buffer = buffer;
        bench.state.read_buffer = ReadBuffer::Back;
        bench.write({0, 0, 1, 1}, {77, 0, 0, 0});
        EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{buffer == DrawBuffer::None ? 0 : 77});
    }
}

// [R16.4]
TEST(ManualSurfaces, DigestsAreOfTheWindow) {
    std::array<Digest, 2> digests;
    for (const bool on_surface : {false, true}) {
        Workbench bench(opengl(), 8, 8);
        CommandList list;
        list.add(MakeSurface{1, {8, 8, color_plane}});
        list.add(BeginPass{"a", color_plane});
        if (on_surface) list.add(UseSurface{1});
        list.add(Clear{color_plane, vec4(1)});
        bench.run(list);
        bench.planes();
        digests[on_surface] = bench.machine().passes().back().digests[0];
        EXPECT_EQ(digests[on_surface], digest(bench.machine().planes(), Plane::Color));
    }
    EXPECT_NE(digests[0], digests[1]);
}

// [R16.5]
TEST(ManualSurfaces, APlaneIsATextureAsItIsNow) {
    Workbench bench(opengl(), 2, 2);
    bench.state.projection = dmat4(1);
    bench.state.texture.env = TexEnv::Replace;
    bench.state.texture.min_filter = MinFilter::Nearest;
    bench.state.texture.mag_filter = MagFilter::Nearest;
    make_reds(bench, 1, 2, 2, {10, 20, 30, 40});
    bench.run(UseSurface{0});
    Draw draw{.mesh = make_mesh(whole_square(0))};
    draw.map.surface = SurfacePlane{1, Plane::Color};
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 2, 2}), (std::vector{10, 20, 30, 40}));
    EXPECT_EQ(bench.take_counters().texels, 4u);
    bench.run(UseSurface{1});
    bench.clear(color_plane, vec4(1));
    bench.run(UseSurface{0});
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 2, 2}), (std::vector{255, 255, 255, 255}));
}

/// Depths as grey, and compared in their own bits.
// [R16.5] [R16.6] [R10.18]
TEST(ManualSurfaces, DepthsAreTexelsOfTheirOwnBits) {
    Profile profile = opengl();
    profile.extensions.shadow_texture = true;
    Workbench bench(profile, 1, 1);
    bench.state.projection = dmat4(1);
    bench.run(MakeSurface{1, {1, 1, depth_plane, 16}});
    bench.run(UseSurface{1});
    bench.clear(depth_plane, vec4(0), 0.5);
    bench.run(UseSurface{0});
    bench.state.texture.env = TexEnv::Replace;
    Draw draw{.mesh = make_mesh(whole_square(0))};
    draw.map.surface = SurfacePlane{1, Plane::Depth};
    bench.draw(draw);
    EXPECT_EQ(bench.color(0, 0), (Rgba{128, 128, 128, 128}));
    bench.state.texture.shadow_compare = true;
    for (const double r : {0.5, 0.5 + 0x1p-8}) {  // in 24 bits both are greater
        bench.state.texture.matrix = dmat4(1);
        bench.state.texture.matrix[3][2] = r;
        bench.draw(draw);
        EXPECT_EQ(bench.color(0, 0)[0], r == 0.5 ? 255 : 0);
    }
}

/// All eight comparisons, on a unit that is not the first.
// [R16.5] [R16.6] [R10.37] [R10.41]
TEST(ManualSurfaces, APlaneOfDepthsIsAShadowMap) {
    Profile profile = opengl();
    profile.extensions.shadow_texture = true;
    Workbench bench(profile, 2, 1);
    bench.state.projection = dmat4(1);
    bench.run(MakeSurface{1, {2, 1, depth_plane, 32}});
    bench.run(UseSurface{1});
    bench.clear(depth_plane, vec4(0), 1);
    bench.state.depth = {.test = true, .func = DepthFunc::Always};
    bench.run(WritePixels{{0, 0, 1, 1}, Plane::Depth, {}, {0x40000000}, 0});
    bench.run(UseSurface{0});
    bench.state.depth = {};
    Draw draw{.mesh = make_mesh(whole_square(0))};
    MoreBindings maps;
    maps[0].surface = SurfacePlane{1, Plane::Depth};
    draw.more_maps = std::make_shared<const MoreBindings>(maps);
    CurrentValues current;
    current.more_texcoords[0] = {0, 0, 0.25f, 1};
    draw.current = std::make_shared<const CurrentValues>(current);
    const auto of = [&](CompareFunc func) {
        std::array<TextureState, max_texture_units - 1> units;
        units[0].env = TexEnv::Replace;
        units[0].shadow_compare = true;
        units[0].compare_func = func;
        units[0].gen = TexGen::PerCoordinate;  // s = (x + 1) / 2; r is given
        units[0].coordinates[0] = {.mode = CoordinateMode::ObjectLinear, .plane = {0.5, 0, 0, 0.5}};
        bench.state.more_textures.units = std::make_shared<const decltype(units)>(units);
        bench.draw(draw);
        return reds(bench, {0, 0, 2, 1});
    };
    using Reds = std::vector<int>;
    EXPECT_EQ(of(CompareFunc::Never), (Reds{0, 0}));
    EXPECT_EQ(of(CompareFunc::Always), (Reds{255, 255}));
    EXPECT_EQ(of(CompareFunc::LEqual), (Reds{255, 255}));
    EXPECT_EQ(of(CompareFunc::Less), (Reds{0, 255}));
    EXPECT_EQ(of(CompareFunc::NotEqual), (Reds{0, 255}));
    EXPECT_EQ(of(CompareFunc::Equal), (Reds{255, 0}));
    EXPECT_EQ(of(CompareFunc::GEqual), (Reds{255, 0}));
    EXPECT_EQ(of(CompareFunc::Greater), (Reds{0, 0}));
}

// [R10.40] [R16.6] Drawn to a surface of 16 bits first, then to the window.
TEST(ManualSurfaces, ADepthTextureHasTheProfilesBits) {
    Profile profile = opengl();
    profile.extensions.shadow_texture = true;
    Workbench bench(profile, 1, 1);
    bench.state.projection = dmat4(1);
    Texture texture{.name = "depths"};
    texture.depths = true;
    texture.format = TextureFormat::Luminance;
    TextureLevel level{1, 1, {}};
    level.rgba.edit() = {0x8000, 0, 0, 0};
    texture.levels.push_back(level);
    Draw draw{.mesh = make_mesh(whole_square(0))};
    draw.map.texture = make_texture(std::move(texture));
    bench.state.texture.env = TexEnv::Replace;
    bench.state.texture.shadow_compare = true;
    bench.state.texture.compare_func = CompareFunc::Less;
    bench.state.texture.matrix[3][2] = 0.5 - 0x1p-20;  // in 24 bits it is less, in 16 by a whole
    bench.run(MakeSurface{1, {1, 1, color_plane, 16}});
    bench.run(UseSurface{1});
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{255});
    bench.run(UseSurface{0});
    bench.state.texture.compare_func = CompareFunc::Equal;
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{0});
    bench.state.texture.matrix[3][2] = 0.5;
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{255});
}

/// Two planes, of two surfaces, on two units.
// [R16.5] [R10.37]
TEST(ManualSurfaces, AnyUnitHasAPlane) {
    Workbench bench(opengl(), 1, 1);
    bench.state.projection = dmat4(1);
    make_reds(bench, 1, 1, 1, {100});
    make_reds(bench, 2, 1, 1, {51});
    bench.run(UseSurface{0});
    Draw draw{.mesh = make_mesh(whole_square(0))};
    draw.map.surface = SurfacePlane{1, Plane::Color};
    MoreBindings maps;
    maps[2].surface = SurfacePlane{2, Plane::Color};
    draw.more_maps = std::make_shared<const MoreBindings>(maps);
    bench.draw(draw);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{20});  // 255 x 100/255 x 51/255
}

// [R16.7] [R16.8] [R16.10]
TEST(ManualSurfaces, ABlitScalesAndFlips) {
    Workbench bench(opengl(), 8, 8);
    make_reds(bench, 1, 4, 1, {0, 100, 200, 40});
    bench.run(MakeSurface{2, {3, 1, color_plane}});
    bench.run(UseSurface{2});
    bench.state.color_mask = {false, false, false, false};  // no mask limits a blit
    Blit blit{.from_surface = 1, .planes = 7, .source = {0, 0, 4, 1}, .target = {0, 0, 3, 1}};
    bench.take_counters();
    bench.run(blit);
    EXPECT_EQ(bench.take_counters().bytes, 3u * 8);
    EXPECT_EQ(reds(bench, {0, 0, 3, 1}), (std::vector{0, 200, 40}));
    blit.filter = MagFilter::Linear;
    bench.run(blit);
    EXPECT_EQ(reds(bench, {0, 0, 3, 1}), (std::vector{16, 150, 67}));
    blit.filter = MagFilter::Nearest;
    blit.flip_x = true;
    bench.run(blit);
    EXPECT_EQ(reds(bench, {0, 0, 3, 1}), (std::vector{40, 200, 0}));
}

// [R16.10] [R14.8]
TEST(ManualSurfaces, ABlitCountsTheBytesOfACopy) {
    Workbench bench(opengl(), 3, 1);
    make_reds(bench, 1, 3, 1, {1, 2, 3});
    bench.run(UseSurface{0});
    for (const auto& [buffer, bytes] :
         {std::pair(DrawBuffer::None, 24u), {DrawBuffer::FrontAndBack, 36u}}) {
        bench.state.draw_buffer = buffer;
        bench.take_counters();
        bench.run(
            Blit{.from_surface = 1, .planes = 7, .source = {0, 0, 3, 1}, .target = {0, 0, 3, 1}});
        const Counters counted = bench.take_counters();
        EXPECT_EQ(counted.pixels, 3u);
        EXPECT_EQ(counted.bytes, bytes);
        EXPECT_EQ(bench.color(2, 0)[0], buffer == DrawBuffer::None ? 0 : 3);
    }
}

// [R16.7] Pixels of the target that show no pixel of the source, and those outside the box, stay.
TEST(ManualSurfaces, ABlitIsCutByBothSurfacesAndTheBox) {
    Workbench bench(opengl(), 8, 8);
    make_reds(bench, 1, 3, 1, {1, 2, 3});
    make_reds(bench, 2, 6, 1, {90, 91, 92, 93, 94, 95});
    bench.state.scissor = {true, {0, 0, 4, 1}};
    bench.run(
        Blit{.from_surface = 1, .planes = 1, .source = {-1, 0, 5, 1}, .target = {1, 0, 5, 1}});
    EXPECT_EQ(reds(bench, {0, 0, 6, 1}), (std::vector{90, 91, 1, 2, 94, 95}));
}

// [R16.9]
TEST(ManualSurfaces, ABlitCopiesThePlanesThatBothHave) {
    Workbench bench(opengl(), 4, 1);
    bench.state.draw_buffer = DrawBuffer::Back;
    bench.clear(color_plane | depth_plane | stencil_plane, vec4(1), 1, 5);
    bench.run(MakeSurface{1, {4, 1, PlaneMask(color_plane | stencil_plane)}});
    bench.run(UseSurface{1});
    Blit blit{.planes = 7, .source = {0, 0, 4, 1}, .target = {0, 0, 4, 1}};
    bench.run(blit);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{0});  // of the front plane
    EXPECT_EQ(read(bench, Plane::Stencil, {0, 0, 1, 1}).values, Words(1, 5));
    bench.state.read_buffer = ReadBuffer::Back;
    bench.run(blit);
    EXPECT_EQ(reds(bench, {0, 0, 1, 1}), std::vector{255});
    bench.run(UseSurface{0});
    bench.state.draw_buffer = DrawBuffer::FrontAndBack;
    bench.state.stencil.write_mask = 0;
    bench.clear(stencil_plane);
    blit.from_surface = 1;
    bench.run(blit);
    EXPECT_EQ(bench.color(3, 0)[0], 255);
    EXPECT_EQ(bench.back(3, 0)[0], 255);
    EXPECT_EQ(bench.stencil(3, 0), 5);
}

// [R16.9] A surface is copied to itself as if it was read first.
TEST(ManualSurfaces, ABlitReadsBeforeItWrites) {
    Workbench bench(opengl(), 8, 8);
    make_reds(bench, 1, 4, 1, {1, 2, 3, 4});
    bench.run(Blit{.from_surface = 1, .planes = 1, .source = {0, 0, 3, 1}, .target = {1, 0, 3, 1}});
    EXPECT_EQ(reds(bench, {0, 0, 4, 1}), (std::vector{1, 1, 2, 3}));
}

// [R16.1] [R1.11] Geometry far from the first tiles, on the largest surface.
TEST(ManualSurfaces, TheLargestHas8192PixelsASide) {
    Workbench bench(opengl(), 8, 8);
    bench.state.projection = dmat4(1);
    bench.run(MakeSurface{1, {8192, 3, color_plane}});
    bench.run(UseSurface{1});
    bench.state.scissor = {true, {8000, 0, 192, 3}};
    bench.draw(Primitive::Triangles, {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}},
               std::vector<vec4>(3, vec4(1)));
    EXPECT_EQ(bench.take_counters().written, 576u);
    EXPECT_EQ(reds(bench, {8191, 2, 1, 1}), std::vector{255});
}

}  // namespace
}  // namespace gw
