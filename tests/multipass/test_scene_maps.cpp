// Reflection and refraction maps generated from the scene [K3.1], against directions worked out by
// hand.
#include "multipass/frame/scene_maps.h"

#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"
#include "tests/multipass/shadow_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::multipass {
namespace {

constexpr int size = 48;

/// A self-luminous square of side 8 whose centre is `at`, turned so that it stands across the line
/// to the origin.
void add_wall(scene::Scene& s, const char* name, const dvec3& at, const vec3& Ke) {
    add_square(s, name, {.Ka = vec3(0), .Kd = vec3(0), .Ke = Ke}, at);
    dmat4& m = s.objects.back().world_from_object;
    const dvec3 n = at / length(at), u = std::abs(n.y) > 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    m[0] = dvec4(u * 4.0, 0);
    m[1] = dvec4(cross3(n, u) * 4.0, 0);
    m[2] = dvec4(n, 0);
}

/// A mirror of two triangles in a cube of six colours, seen from the front.
scene::Scene in_a_cube(int texels) {
    scene::Scene s;
    add_square(s, "mirror", {.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(1)});
    s.materials[0].refl = {{.wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .from_scene = texels}};
    add_wall(s, "right", {4, 0, 0}, {1, 0, 0});
    add_wall(s, "left", {-4, 0, 0}, {0, 1, 0});
    add_wall(s, "above", {0, 4, 0}, {0, 0, 1});
    add_wall(s, "below", {0, -4, 0}, {1, 1, 0});
    add_wall(s, "front", {0, 0, 4}, {1, 0, 1});
    add_wall(s, "back", {0, 0, -4}, {0, 1, 1});
    s.camera = scene::Camera{.eye = {0, 0, 3.5}, .fov = 40};
    return s;
}

TextureRef map_of(const scene::Scene& s, const Profile& profile = vgx(), int window = size) {
    const auto machine = make_reference(profile, window, window);
    const scene::Scene ready =
        with_scene_maps(*machine, s, scene::make_view(s, window, window), {});
    return ready.materials[ready.objects[0].material].refl.at(0).texture;
}

using Texel = std::array<int, 3>;
Texel texel(const TextureRef& map, int i, int j) {
    const TextureLevel& level = map->levels.front();
    const std::size_t at = std::size_t(j * level.width + i) * 4;
    return {level.rgba[at] / 257, level.rgba[at + 1] / 257, level.rgba[at + 2] / 257};
}

TEST(SphereMap, DirectionsAreTheInverseOfTheMachinesLookUp) {
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 20; ++i) {
            const double s = (i + 0.5) / 20, t = (j + 0.5) / 20;
            const dvec3 d = direction_of(s, t);
            EXPECT_NEAR(dot3(d, d), 1, 1e-12);
            if ((2 * s - 1) * (2 * s - 1) + (2 * t - 1) * (2 * t - 1) >= 1) {
                EXPECT_EQ(d, dvec3(0, 0, -1)) << "beyond the rim is the rim";
                continue;
            }
            // docs/manual/texture.md: m = 2 sqrt(dx dx + dy dy + (dz + 1)(dz + 1)).
            const double m = 2 * std::sqrt(d.x * d.x + d.y * d.y + (d.z + 1) * (d.z + 1));
            EXPECT_NEAR(d.x / m + 0.5, s, 1e-12);
            EXPECT_NEAR(d.y / m + 0.5, t, 1e-12);
        }
}

TEST(SphereMap, TexelsAreSixteenBitsToNearest) {
    CubePicture around;
    for (const std::uint16_t v : {0, 1, 200, 3000, 4095}) {
        for (std::size_t face = 0; face < 6; ++face) {
            around.views[face].width = around.views[face].height = 1;
            around.colors[face] = {{v, v, v, 4095}};
        }
        const TextureRef map = sphere_map("even", around, dmat4(1), 4, 12);
        EXPECT_EQ(map->levels.front().rgba[0], std::uint16_t(std::floor(v * 65535.0 / 4095 + 0.5)))
            << v;
    }
}

TEST(SceneMap, ShowsEachWallWhereItsDirectionLies) {
    for (const Profile& profile : paper_profiles()) {
        const TextureRef map = map_of(in_a_cube(32), profile);
        ASSERT_TRUE(map);
        EXPECT_EQ(map->width(), 32);
        EXPECT_EQ(texel(map, 16, 16), (Texel{255, 0, 255}))
            << "straight back: in front of the mirror";
        // A reflected ray at right angles: |2 z x| = 1 at x = sqrt(1/2), 0.354 of the width from
        // the middle.
        EXPECT_EQ(texel(map, 16 + 11, 16), (Texel{255, 0, 0}));
        EXPECT_EQ(texel(map, 15 - 11, 16), (Texel{0, 255, 0}));
        EXPECT_EQ(texel(map, 16, 16 + 11), (Texel{0, 0, 255}));
        EXPECT_EQ(texel(map, 16, 15 - 11), (Texel{255, 255, 0}));
        EXPECT_EQ(texel(map, 0, 16), (Texel{0, 255, 255})) << "the rim: behind";
        EXPECT_EQ(texel(map, 0, 0), (Texel{0, 255, 255}));
    }
}

TEST(SceneMap, FollowsTheEye) {
    // From the right side the mirror's "straight back" is the right wall.
    scene::Scene s = in_a_cube(32);
    s.camera->eye = {3.5, 0, 0};
    EXPECT_EQ(texel(map_of(s), 16, 16), (Texel{255, 0, 0}));
    EXPECT_EQ(texel(map_of(s), 16 + 11, 16), (Texel{0, 255, 255}))
        << "the back wall is at the right then";
}

TEST(SceneMap, LeavesTheObjectItselfOut) {
    scene::Scene s = in_a_cube(32);
    s.materials[0].Ke = vec3(1);
    EXPECT_EQ(map_of(s)->levels, map_of(in_a_cube(32))->levels);
}

TEST(SceneMap, OfAFarReachShowsWhatIsNear) {
    // Behind the wall in front: all walls are within a 4096th of its distance.
    scene::Scene s = in_a_cube(32);
    add_wall(s, "far", {0, 0, 40000}, {1, 1, 1});
    EXPECT_EQ(map_of(s)->levels, map_of(in_a_cube(32))->levels);
}

TEST(SceneMap, OfAnObjectAloneIsTheBackground) {
    scene::Scene s = in_a_cube(16);
    s.objects.resize(1);
    s.background = {0, 1, 0};
    EXPECT_EQ(texel(map_of(s), 8, 8), (Texel{0, 255, 0}));
}

TEST(SceneMap, IsTheSameFromWindowsThatAreSmaller) {
    // Views of 64 pixels in windows of 32: an exact scale, so the same bits.
    EXPECT_EQ(map_of(in_a_cube(32), vgx(), 32)->levels, map_of(in_a_cube(32), vgx(), 64)->levels);
}

TEST(SceneMap, OfSeveralMirrorsShowsTheOthersWithoutTheirs) {
    scene::Scene s = in_a_cube(16);
    s.objects[5].material = 0;  // the wall in front is a mirror too
    EXPECT_EQ(texel(map_of(s), 8, 8), (Texel{0, 0, 0}));
}

TEST(SceneMap, IsDrawnInThePicture) {
    // The mirror turned by 45 degrees shows the right wall.
    scene::Scene s = in_a_cube(64);
    s.objects[0].world_from_object[0] = dvec4(0.5, 0, -0.5, 0);
    s.objects[0].world_from_object[2] = dvec4(0.5, 0, 0.5, 0);
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {});
    EXPECT_EQ(machine->planes().color[size / 2 * size + size / 2], (Rgba{255, 0, 0, 255}));
    // Its component, which is drawn on black, shows it too.
    for (const ComponentImage& image :
         render_components(*machine, s, scene::make_view(s, size, size), {}))
        if (image.name == "reflection") {
            EXPECT_EQ(image.color[size / 2 * size + size / 2], (Rgba{255, 0, 0, 255}));
        }
}

TEST(SceneMap, OfARefractingBodyShowsWhatIsBehindIt) {
    // Ni = 1 bends nothing: the ray goes straight on, to the back wall. The body is small and
    // beside the middle: rays to its corners then lie together at the map's rim.
    scene::Scene s = in_a_cube(64);
    s.materials[0] = {.Ka = vec3(0), .Kd = vec3(0), .Ni = 1, .Tf = vec3(1)};
    s.materials[0].refraction = {{.wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .from_scene = 64}};
    dmat4& m = s.objects[0].world_from_object;
    m[0] = dvec4(0.1, 0, 0, 0);
    m[1] = dvec4(0, 0.1, 0, 0);
    m[3] = dvec4(1.1, 0, 0, 1);
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {});
    // Filtering over the rim adds a little of the wall beside it.
    const Rgba seen = machine->planes().color[size / 2 * size + 44];
    EXPECT_GE(seen[1], 200);
    EXPECT_EQ(seen[1], seen[2]);
    EXPECT_LE(seen[0], 55);
    s.materials[0].Tf = vec3(0);
    render(*machine, s, scene::make_view(s, size, size), {});
    EXPECT_EQ(machine->planes().color[size / 2 * size + 44], (Rgba{0, 0, 0, 255}))
        << "it was drawn";
}

TEST(SceneMap, HoldsShadows) {
    // A mirror over a floor sees the caster's shadow: with and without, the map differs.
    Case shadowed;
    add_square(shadowed.s, "mirror", {.Ks = vec3(1)}, {-2, 1, 1});
    shadowed.s.materials.back().refl = {{.from_scene = 64}};
    std::rotate(shadowed.s.objects.begin(), shadowed.s.objects.end() - 1, shadowed.s.objects.end());
    scene::Scene plain = shadowed.s;
    plain.lights[0].shadow = scene::Shadow::None;
    EXPECT_NE(map_of(shadowed.s)->levels, map_of(plain)->levels);
    scene::Scene by_map = shadowed.s;
    by_map.lights[0].shadow = scene::Shadow::Map;
    EXPECT_NE(map_of(by_map)->levels, map_of(plain)->levels);
}

}  // namespace
}  // namespace gw::multipass
