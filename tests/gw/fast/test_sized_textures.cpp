// Textures of any size and wrap, also of three dimensions, on the fast machine: the texels that the
// reference machine looks up, at coordinates of every magnitude.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <array>
#include <cmath>

namespace gw::test {
namespace {

TextureRef noise_of(Random& random, int width, int height) {
    std::vector<std::uint16_t> texels(std::size_t(4 * width * height));
    for (std::uint16_t& t : texels) t = std::uint16_t(random.between(0, 65535));
    return make_whole_texture("noise", width, height, texels);
}

/// Levels that it lacks are never looked up: its filters do not depend on rho.
TextureRef volume_of(Random& random, int width, int height, int layers) {
    Texture t{.name = "volume", .dimensions = 3, .given_levels = true};
    std::vector<std::uint16_t> texels(std::size_t(4 * width * height * layers));
    for (std::uint16_t& texel : texels) texel = std::uint16_t(random.between(0, 65535));
    t.levels.push_back({width, height, std::move(texels), layers});
    return std::make_shared<const Texture>(std::move(t));
}

template <class T, std::size_t n>
T one_of(Random& random, const std::array<T, n>& values) {
    return values[std::size_t(random.between(0, int(n) - 1))];
}

constexpr std::array wraps{Wrap::Repeat, Wrap::Clamp, Wrap::BorderClamp, Wrap::ClampToBorder,
                           Wrap::MirroredRepeat};
constexpr std::array min_filters{MinFilter::Nearest,
                                 MinFilter::Linear,
                                 MinFilter::NearestMipmapNearest,
                                 MinFilter::LinearMipmapNearest,
                                 MinFilter::NearestMipmapLinear,
                                 MinFilter::LinearMipmapLinear};
constexpr std::array sides{1, 3, 8, 49, 64, 100};

void set_texture(Random& random, TextureState& s) {
    s.wrap_s = one_of(random, wraps);
    s.wrap_t = one_of(random, wraps);
    s.min_filter = one_of(random, min_filters);
    s.mag_filter = random.one_in(2) ? MagFilter::Nearest : MagFilter::Linear;
    s.border_color = vec4(0.2f, 0.9f, 0.4f, 0.6f);
    if (random.one_in(3)) s.lod.base_level = int(random.between(0, 2));
    if (random.one_in(3)) s.lod.max_level = int(random.between(0, 4));
}

/// A quad over most of the window, or a small one, in perspective. A third has q.
MeshData quad(Random& random) {
    const float right = random.one_in(4) ? 6.0f : 50.0f;
    MeshData data = mesh_data(Primitive::Quads,
                              {{-2, -3, 50}, {right, 2, 50}, {right - 3, 60, 90}, {3, 66, 90}});
    const float scale = std::ldexp(1.0f, int(random.between(-3, 62)));
    for (int k = 0; k < 4; ++k)
        data.texcoords.push_back({scale * (random.fraction() - 0.5f),
                                  std::ldexp(random.fraction(), int(random.between(0, 6)))});
    if (random.one_in(2)) std::swap(data.texcoords[0].x, data.texcoords[0].y);
    if (random.one_in(3))
        for (int k = 0; k < 4; ++k) data.texcoords_rq.push_back({0, random.fraction() - 0.1f});
    return data;
}

/// A triangle whose left side has the least denominators that there are: the coordinates of its
/// pixels are the largest.
MeshData pole(Random& random) {
    MeshData data = mesh_data(Primitive::Triangles, {{4.5f, 2, 9}, {60, 30, 9}, {4.5f, 60, 9}});
    const float scale = std::ldexp(1.0f, int(random.between(6, 10)));
    for (int k = 0; k < 3; ++k) {
        data.texcoords.push_back(
            {scale * (random.fraction() - 0.5f), scale * (random.fraction() - 0.5f)});
        data.texcoords_rq.push_back({0, k == 1 ? 1.0f : 1e-9f});
    }
    return data;
}

/// Draws on both machines.
void draw_alike(Workbench& bench, Draw draw) {
    CommandList list;
    list.add(SetState{bench.state});
    list.add(Clear{.planes = all_planes});
    list.add(std::move(draw));
    bench.run(list);
    bench.compare();
}

/// 600 textures on what `mesh` makes.
void compare(MeshData (*mesh)(Random&)) {
    Random random(1);
    Workbench bench(opengl());
    bench.state.color_source = ColorSource::Vertex;
    for (int i = 0; i < 600; ++i) {
        SCOPED_TRACE(i);
        set_texture(random, bench.state.texture);
        Draw draw{.mesh = make_mesh(mesh(random))};
        draw.map.texture = random.one_in(3)
                               ? noise_of(random, int(random.between(2049, 4096)), 3)
                               : noise_of(random, one_of(random, sides), one_of(random, sides));
        draw_alike(bench, std::move(draw));
        if (testing::Test::HasFailure()) return;
    }
}

/// 600 volumes, with an r of any magnitude too.
void compare_volumes(MeshData (*mesh)(Random&)) {
    Random random(2);
    Workbench bench(opengl());
    bench.state.color_source = ColorSource::Vertex;
    for (int i = 0; i < 600; ++i) {
        SCOPED_TRACE(i);
        TextureState& s = bench.state.texture;
        set_texture(random, s);
        s.wrap_r = one_of(random, wraps);
        s.min_filter = random.one_in(2) ? MinFilter::Nearest : MinFilter::Linear;
        s.mag_filter = s.min_filter == MinFilter::Linear ? MagFilter::Linear : MagFilter::Nearest;
        s.lod = {};
        MeshData data = mesh(random);
        const float scale = std::ldexp(1.0f, int(random.between(-3, 50)));
        if (data.texcoords_rq.empty()) data.texcoords_rq.resize(data.texcoords.size(), {0, 1});
        for (auto& rq : data.texcoords_rq) rq.x = scale * (random.fraction() - 0.5f);
        Draw draw{.mesh = make_mesh(std::move(data))};
        draw.map.texture = volume_of(random, one_of(random, sides), one_of(random, sides),
                                     int(random.between(1, 9)));
        draw_alike(bench, std::move(draw));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(SizedTextures, HaveTheReferencesTexelsAtAnyCoordinate) { compare(quad); }
TEST(SizedTextures, HaveThemWhereQIsNearlyZero) { compare(pole); }
TEST(SizedTextures, OfThreeDimensionsHaveThemAtAnyCoordinate) { compare_volumes(quad); }
TEST(SizedTextures, OfThreeDimensionsHaveThemWhereQIsNearlyZero) { compare_volumes(pole); }

}  // namespace
}  // namespace gw::test
