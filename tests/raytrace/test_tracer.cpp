// [L9, K4]: reflected and transmitted light where it can be said in advance.
#include "raytrace/tracer/tracer.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gw::raytrace {
namespace {

/// What a ray from the eye sees: local and traced light of the first hit.
struct Seen {
    dvec3 local{0}, traced{0};
    RayCounts counts;
};

Seen look(const scene::Scene& scene, const dvec3& direction, const TraceOptions& options,
          const dvec3& origin = dvec3(0, 0, 5)) {
    const World world(scene, 1);
    const scene::View view = scene::make_view(scene, 64, 64);
    const Tracer tracer(scene, world, view, options);
    const dvec3 d = normalized(direction);
    const auto at = world.nearest({origin, d}, std::numeric_limits<double>::infinity());
    Seen seen;
    if (!at) return seen;
    const Surface s = surface(world.triangles(), *at, d, view);
    seen.local = tracer.local(s, seen.counts);
    seen.traced = tracer.traced(s, seen.counts);
    return seen;
}

/// A mirror at z = 0 before the eye; something red behind the eye.
Walls mirror_and_lamp() {
    Walls walls;
    walls.add_shining({0, 0, 10}, {-9, 0, 0}, {0, 9, 0}, {0.75f, 0.5f, 0.25f});
    scene::Material& mirror = walls.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    mirror.Ks = {0.5f, 0.25f, 1};
    mirror.illum = 3;
    return walls;
}

TEST(Tracer, ReflectsKsTimesWhatTheMirrorSees) {
    const Seen seen = look(mirror_and_lamp().scene, {0.1, 0.05, -1}, {});
    EXPECT_EQ(seen.local, dvec3(0));
    EXPECT_EQ(seen.traced, dvec3(0.375, 0.125, 0.25));
    EXPECT_EQ(seen.counts.reflected, 1u);
    EXPECT_EQ(seen.counts.transmitted, 0u);
}

TEST(Tracer, TracesIllum3To7Only) {
    for (int illum = 0; illum <= 10; ++illum) {
        Walls walls = mirror_and_lamp();
        walls.scene.materials[1].illum = illum;
        const bool traced = illum >= 3 && illum <= 7;
        EXPECT_EQ(look(walls.scene, {0, 0, -1}, {}).counts.reflected, traced ? 1u : 0u) << illum;
    }
}

TEST(Tracer, GivesTheBackgroundOrTheReflectionMapWhereARayLeaves) {
    Walls walls;
    scene::Material& mirror = walls.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    mirror.Ks = vec3(1);
    mirror.illum = 3;
    walls.scene.background = {0.25f, 0.5f, 0.125f};
    EXPECT_EQ(look(walls.scene, {0, 0, -1}, {}).traced, dvec3(0.25, 0.5, 0.125));
    const std::array<std::uint8_t, 4> texel{255, 0, 51, 255};
    walls.scene.materials[0].refl.emplace_back();
    walls.scene.materials[0].refl[0].texture = make_texture8("far", 1, 1, texel);
    const dvec3 far = look(walls.scene, {0, 0, -1}, {}).traced;
    EXPECT_DOUBLE_EQ(far.x, 1);
    EXPECT_DOUBLE_EQ(far.y, 0);
    EXPECT_DOUBLE_EQ(far.z, 0.2);
}

/// Mirrors face to face, each shining Ke: depth n sees Ke (1 + Ks + Ks^2 + ...), n terms.
TEST(Tracer, FollowsPathsAsDeepAsAsked) {
    Walls walls;
    for (const float z : {-2.0f, 2.0f}) {
        scene::Material& m = walls.add({0, 0, z}, {z < 0 ? 4.0f : -4.0f, 0, 0}, {0, 4, 0});
        m.Ks = vec3(0.5f);
        m.Ke = vec3(0.25f);
        m.illum = 3;
    }
    double sum = 0, term = 0.25;
    for (int depth = 1; depth <= 8; ++depth, term /= 2) {
        sum += term;
        const Seen seen = look(walls.scene, {0, 0, -1}, {.depth = depth}, {0, 0, 0});
        EXPECT_EQ(seen.local.x + seen.traced.x, sum) << depth;
        EXPECT_EQ(seen.counts.reflected, std::uint64_t(depth - 1));
    }
}

TEST(Tracer, TellsTheRaysThatItFollows) {
    Walls walls = mirror_and_lamp();
    walls.add({0, 0, 7}, {0.3f, 0, 0}, {0, 0.3f, 0});  // before the wall: it has a shadow there
    walls.scene.materials[0].Kd = vec3(0.5f);
    walls.scene.lights.push_back(
        {.kind = scene::LightKind::Point, .position = {0, 0, 6.5f}, .shadow = scene::Shadow::Map});
    std::vector<FollowedRay> rays;
    const TraceOptions options{.followed = [&](const FollowedRay& ray) { rays.push_back(ray); }};
    for (const double x : {0.125, 0.3}) {
        rays.clear();
        const dvec3 eye(0, 0, 2);
        const Seen seen = look(walls.scene, {x, 0, -1}, options, eye);
        EXPECT_EQ(seen.traced, look(walls.scene, {x, 0, -1}, {}, eye).traced);
        ASSERT_EQ(rays.size(), seen.counts.reflected + seen.counts.shadow);
        // The mirror's shadow ray, the reflected ray to the wall, the wall's shadow ray.
        ASSERT_EQ(rays.size(), 3u);
        EXPECT_TRUE(rays[0].light && rays[0].arrives);
        EXPECT_FALSE(rays[1].light);
        EXPECT_TRUE(rays[1].above);
        EXPECT_EQ(rays[1].number, 2);
        EXPECT_EQ(rays[1].part, 1);  // the largest of Ks
        ASSERT_TRUE(rays[1].hit);
        EXPECT_EQ(rays[1].hit->p.z, 10);
        EXPECT_EQ(rays[2].from.z, 10);
        EXPECT_EQ(rays[2].arrives, x > 0.2);
    }
}

TEST(Tracer, LetsThroughWhatIsNotOpaque) {
    Walls walls;
    walls.add_shining({0, 0, -5}, {9, 0, 0}, {0, 9, 0}, {0.5f, 0.5f, 0.5f});
    scene::Material& pane = walls.add({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    pane.illum = 4;
    pane.d = 0.25f;
    pane.Tf = {1, 0.5f, 0};
    const Seen seen = look(walls.scene, {0.2, 0, -1}, {});
    EXPECT_EQ(seen.traced, dvec3(0.375, 0.1875, 0));
    EXPECT_EQ(seen.counts.transmitted, 1u);
}

/// A slab of glass, Ni = 1.5, shifts a slanted ray sideways by what Snellius says and lets it go on
/// parallel.
TEST(Tracer, BendsByNi) {
    Walls walls;
    for (const float z : {0.0f, -1.0f}) {
        scene::Material& face = walls.add({0, 0, z}, {z == 0 ? 6.0f : -6.0f, 0, 0}, {0, 6, 0});
        face.illum = 6;
        face.d = 0;
        face.Ni = 1.5f;
    }
    // At 45 degrees from (0, 0, 5): enters at x = 5; leaves at 5 + tan(t), sin t = sin 45 / 1.5.
    const double sine = std::sqrt(0.5) / 1.5, leave = 5 + sine / std::sqrt(1 - sine * sine);
    const double at_screen = leave + 3;  // the screen is 3 behind the slab
    for (const double side : {-0.001, 0.001}) {
        Walls with_edge = walls;
        with_edge.add_shining({float(at_screen + side) + 10, 0, -4}, {10, 0, 0}, {0, 6, 0},
                              vec3(1));
        const Seen seen = look(with_edge.scene, {1, 0, -1}, {.depth = 3});
        EXPECT_EQ(seen.traced, dvec3(side < 0 ? 1 : 0)) << side;
        EXPECT_EQ(seen.counts.transmitted, 2u);
    }
}

TEST(Tracer, ReflectsTotallyFromInsideBeyondTheCriticalAngle) {
    Walls walls;
    scene::Material& water = walls.add({0, 0, 0}, {9, 0, 0}, {0, 9, 0});
    water.illum = 6;
    water.d = 0;
    water.Ni = 1.5f;
    walls.add_shining({0, 0, -9}, {90, 0, 0}, {0, 90, 0}, {0.5f, 0, 0});  // inside, below
    walls.scene.background = vec3(0, 1, 0);                               // outside
    // From below: critical at sin = 1 / 1.5.
    const auto up = [&](double sine) {
        return look(walls.scene, {sine, 0, std::sqrt(1 - sine * sine)}, {}, {0, 0, -1}).traced;
    };
    EXPECT_EQ(up(0.66), dvec3(0, 1, 0));
    EXPECT_EQ(up(0.67), dvec3(0.5, 0, 0));
}

TEST(Tracer, ReflectsMoreAtGrazingAnglesWhereFresnelIsAskedFor) {
    Walls walls = mirror_and_lamp();
    walls.scene.materials[1].Ks = vec3(0.25f);
    walls.scene.objects.erase(walls.scene.objects.begin());
    walls.scene.background = vec3(1);
    for (const int illum : {3, 5}) {
        walls.scene.materials[1].illum = illum;
        const double cosine = 0.5, expected = illum == 3 ? 0.25 : 0.25 + 0.75 / 32;
        const Seen seen = look(walls.scene, {std::sqrt(0.75), 0, -cosine}, {}, {-0.8, 0, 0.5});
        EXPECT_NEAR(seen.traced.x, expected, 1e-12) << illum;
    }
}

/// Schlick's F from the thinner medium's cosine, by the refracted angle's trigonometry.
double fresnel_from_inside(double Ks, double Ni, double sine) {
    const double outside = Ni * sine;
    if (outside >= 1) return 1;
    return Ks + (1 - Ks) * std::pow(1 - std::cos(std::asin(outside)), 5);
}

// F grows to 1 at the critical angle and stays there, whatever the body absorbs of what it lets
// through.
TEST(Tracer, ReflectsAllLightFromInsideBeyondTheCriticalAngleWhereFresnelIsAskedFor) {
    for (const int illum : {5, 7})
        for (const float d : {0.0f, 0.2f, 0.9f})
            for (const float Tf : {0.5f, 1.0f}) {
                Walls walls;
                scene::Material& glass = walls.add({0, 0, 0}, {90, 0, 0}, {0, 90, 0});
                glass = {.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(0.04f), .Tf = vec3(Tf)};
                glass.illum = illum;
                glass.d = d;
                glass.Ni = 1.5f;
                walls.add_shining({0, 0, -900}, {9000, 0, 0}, {0, 9000, 0}, {1, 0, 0});  // inside
                walls.scene.background = vec3(0, 1, 0);                                  // outside
                for (const double sine : {0.1, 0.5, 0.6, 0.66, 0.6666, 0.6667, 0.7, 0.9, 0.99}) {
                    const dvec3 up(sine, 0, std::sqrt(1 - sine * sine));
                    const dvec3 seen = look(walls.scene, up, {}, {0, 0, -1}).traced;
                    const double F = fresnel_from_inside(double(0.04f), 1.5, sine);
                    EXPECT_NEAR(seen.x, F, 1e-9) << illum << " " << d << " " << sine;
                    EXPECT_NEAR(seen.y, (1 - F) * (1 - double(d)) * double(Tf), 1e-9) << sine;
                }
            }
}

TEST(Tracer, FindsShadowsOfHitsByRaysOrAsToldByOption) {
    Walls walls = mirror_and_lamp();
    scene::Material& lamp = walls.scene.materials[0];
    lamp.Ke = vec3(0);
    lamp.Kd = vec3(0.5f);
    // before the wall, between it and the light
    walls.add({0, 0, 7}, {0.3f, 0, 0}, {0, 0.3f, 0});
    walls.scene.lights.push_back(
        {.kind = scene::LightKind::Point, .position = {0, 0, 6.5f}, .shadow = scene::Shadow::Map});
    const dvec3 to_middle{0.125, 0, -1}, to_side{0.3, 0, -1};
    const Seen dark = look(walls.scene, to_middle, {}, {0, 0, 2}),
               lit = look(walls.scene, to_side, {}, {0, 0, 2});
    EXPECT_EQ(dark.traced, dvec3(0));
    EXPECT_GT(lit.traced.x, 0.1);
    EXPECT_EQ(dark.counts.shadow, 2u) << "the mirror's and the wall's";
    int asked = 0;
    const auto told = [&](std::size_t, const scene::TrianglePoint&) { return ++asked, false; };
    const Seen by_option = look(walls.scene, to_middle, {.in_shadow = told}, {0, 0, 2});
    EXPECT_EQ(by_option.counts.shadow, 1u);
    EXPECT_EQ(asked, 1);
    EXPECT_GT(by_option.traced.x, 0.1);
}

TEST(DrawnScene, DrawsWhatTransmitsAsOpaqueAndWithoutShadow) {
    Walls walls = mirror_and_lamp();
    scene::Material& glass = walls.add({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    glass = {.Ka = vec3(0.5f), .Kd = vec3(0.5f), .Ks = vec3(0.25f), .d = 0.5f, .illum = 7};
    const scene::Scene drawn = drawn_scene(walls.scene);
    EXPECT_EQ(drawn.materials[2].d, 1.0f);
    EXPECT_EQ(drawn.materials[2].Kd, vec3(0.25f));
    EXPECT_EQ(drawn.materials[2].Ks, vec3(0.25f));
    EXPECT_FALSE(drawn.objects[2].casts_shadow);
    EXPECT_TRUE(drawn.objects[1].casts_shadow);
    EXPECT_FALSE(any_traced(drawn_scene(Walls().scene)));
}

}  // namespace
}  // namespace gw::raytrace
