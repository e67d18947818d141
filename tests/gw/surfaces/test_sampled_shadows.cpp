// docs/manual/samples.md: a lit surface in pieces is lit at every sample. On both machines.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <memory>
#include <utility>
#include <vector>

namespace gw {
namespace {

constexpr int side = 16, map_side = 64;

/// Texel (i, j) has the depth (i + j) / (4 map_side).
Texture ramp() {
    Texture t{.name = "ramp"};
    t.format = TextureFormat::Intensity;
    t.depths = true;
    TextureLevel level{map_side, map_side, {}};
    for (int j = 0; j < map_side; ++j)
        for (int i = 0; i < map_side; ++i) {
            const auto high = std::uint16_t((i + j) * (65536 / (4 * map_side)));
            for (const std::uint16_t word : {high, std::uint16_t(0), high, high})
                level.rgba.edit().push_back(word);
        }
    t.levels = {level};
    return t;
}

/// The window cut into a fan of triangles around a point. s and t go from 0 to 1; r is the depth of
/// the ramp there, less what a pixel of an eighth would change.
MeshData fan_around(float x, float y, test::Random& random) {
    MeshData data{.primitive = Primitive::TriangleFan};
    const auto add = [&](float px, float py) {
        const float s = (px + 1) / 2, t = (py + 1) / 2;
        data.positions.emplace_back(px, py, 0);
        data.texcoords.emplace_back(s, t);
        data.texcoords_rq.emplace_back((s + t) / 4 - 0.01f, 1);
    };
    add(x, y);
    constexpr std::pair<float, float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t k = 0; k < 5; ++k) {
        const auto [px, py] = corners[k % 4];
        const auto [nx, ny] = corners[(k + 1) % 4];
        add(px, py);
        for (float f = 0; k < 4 && (f += 0.3f * random.fraction()) < 1;)
            add(px + f * (nx - px), py + f * (ny - py));
    }
    return data;
}

// [R17.3] [R17.8] [R10.41]
TEST(ManualSamples, ALitSurfaceInPiecesIsLit) {
    test::Random random(3);
    for (int round = 0; round < 12; ++round) {
        test::Workbench bench(opengl(), side, side);
        State& state = bench.state;
        state.projection = dmat4(1);
        bench.run(MakeSurface{1, {side, side, surface_planes, 0, 2 << round % 3}});
        bench.run(UseSurface{1});
        state.texture = {.min_filter = MinFilter::Nearest, .mag_filter = MagFilter::Nearest};
        state.texture.env = TexEnv::Replace;
        state.texture.shadow_compare = true;
        const auto at = [&] { return 1.8f * random.fraction() - 0.9f; };
        const float x = at(), y = at();
        Draw draw{.mesh = make_mesh(fan_around(x, y, random))};
        draw.map.texture = make_texture(ramp());
        bench.draw(draw);
        bench.run(UseSurface{0});
        const Rect all{0, 0, side, side};
        bench.run(
            Blit{.from_surface = 1, .planes = mask_of(Plane::Color), .source = all, .target = all});
        // At the window's sides, samples are left out.
        for (int j = 1; j < side - 1; ++j)
            for (int i = 1; i < side - 1; ++i)
                EXPECT_EQ(bench.color(i, j)[0], 255) << round << ": " << i << " " << j;
    }
}

}  // namespace
}  // namespace gw
