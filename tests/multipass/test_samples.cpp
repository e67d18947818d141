// What moves from picture to picture: objects, lights, the points of glares.
#include "multipass/frame/samples.h"

#include "gw/stages/vertex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace gw::multipass {
namespace {

constexpr std::size_t count = 16;

/// The scene of every sample, in the order of `key`.
std::vector<double> sorted(const scene::Scene& still,
                           const std::function<double(const scene::Scene&)>& key) {
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) {
        scene::Scene now = still;
        move_to(now, still, {k, count});
        values.push_back(key(now));
    }
    std::sort(values.begin(), values.end());
    return values;
}

/// The middles of `count` equal parts of low .. high.
std::vector<double> middles(double low, double high) {
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k)
        values.push_back(low + (high - low) * (double(k) + 0.5) / count);
    return values;
}

scene::Scene one_object() {
    scene::Scene s;
    s.objects.push_back({.name = "moving", .move = {4, -2, 0}});
    s.objects.back().world_from_object[3] = dvec4(1, 1, 1, 1);
    return s;
}

TEST(MoveTo, LetsAnObjectPassItsPlaceInTheMiddleOfTheExposure) {
    const scene::Scene still = one_object();
    const auto at = [](int k) {
        return [k](const scene::Scene& s) { return s.objects[0].world_from_object[3][k]; };
    };
    EXPECT_EQ(sorted(still, at(0)), middles(1 - 2, 1 + 2));
    EXPECT_EQ(sorted(still, at(1)), middles(1 - 1, 1 + 1));
    EXPECT_EQ(sorted(still, at(2)), std::vector<double>(count, 1));
    EXPECT_EQ(sorted(still, at(3)), std::vector<double>(count, 1));
}

TEST(MoveTo, LeavesASingleSampleWhereItIs) {
    scene::Scene still = one_object();
    still.lights.push_back({.kind = scene::LightKind::Point, .position = {1, 2, 3}});
    still.lights[0].area = {.shape = scene::AreaLight::Shape::Line, .u = {1, 0, 0}};
    scene::Scene now = still;
    move_to(now, still, {});
    EXPECT_EQ(now.objects[0].world_from_object, still.objects[0].world_from_object);
    EXPECT_EQ(now.lights[0].position, still.lights[0].position);
    EXPECT_TRUE(moves(still));
    still.objects[0].move = dvec3(0);
    EXPECT_TRUE(moves(still)) << "its lamp does";
    still.lights[0].area.shape = scene::AreaLight::Shape::None;
    EXPECT_FALSE(moves(still));
}

scene::Scene one_light(scene::LightKind kind, scene::AreaLight::Shape shape) {
    scene::Scene s;
    s.lights.push_back({.kind = kind, .position = {8, 0, 0}, .direction = {0, -8, 0}});
    s.lights[0].area = {.shape = shape, .u = {0, 0, 2}, .v = {0, 4, 0}};
    return s;
}

TEST(MoveTo, SpreadsALampOverItsLine) {
    const scene::Scene still = one_light(scene::LightKind::Point, scene::AreaLight::Shape::Line);
    EXPECT_EQ(sorted(still, [](const auto& s) { return s.lights[0].position.z; }), middles(-2, 2));
    for (const double y : sorted(still, [](const auto& s) { return s.lights[0].position.y; }))
        EXPECT_EQ(y, 0) << "v is not a line's";
}

TEST(MoveTo, SpreadsALampOverItsRectangle) {
    for (const auto kind : {scene::LightKind::Point, scene::LightKind::Spot}) {
        const scene::Scene still = one_light(kind, scene::AreaLight::Shape::Rectangle);
        const auto at = [&](int k) {
            return sorted(still, [k](const auto& s) { return s.lights[0].position[k]; });
        };
        EXPECT_EQ(at(0), std::vector<double>(count, 8));
        EXPECT_EQ(at(1), middles(-4, 4));
        EXPECT_EQ(at(2), middles(-2, 2));
    }
}

TEST(MoveTo, SpreadsASunsDirectionOverItsDisc) {
    const scene::Scene still =
        one_light(scene::LightKind::Directional, scene::AreaLight::Shape::Disc);
    EXPECT_EQ(sorted(still, [](const auto& s) { return s.lights[0].position.x; }),
              std::vector<double>(count, 8));
    const auto radii = sorted(still, [](const scene::Scene& s) {
        const vec3 d = s.lights[0].direction - vec3(0, -8, 0);
        return double(d.z / 2 * (d.z / 2) + d.y / 4 * (d.y / 4));
    });
    EXPECT_LT(radii.back(), 1);
    const auto inner =
        std::count_if(radii.begin(), radii.end(), [](double r2) { return r2 < 0.5; });
    EXPECT_NEAR(double(inner), count / 2.0, 2) << "half of them in half of the area";
}

/// [Haeberli 1990] A star of four rays: up, right, down, left, as many samples in each.
TEST(GlareDisplacement, LiesOnTheRaysOfItsStar) {
    std::vector<double> up, right, down, left;
    for (std::size_t k = 0; k < count; ++k) {
        const dvec3 d = glare_displacement({.radius = 2, .rays = 4}, {k, count});
        EXPECT_EQ(d.z, 0);
        const bool vertical = std::abs(d.y) > std::abs(d.x);
        EXPECT_LT(vertical ? std::abs(d.x) : std::abs(d.y), 1e-12);
        (vertical ? d.y > 0 ? up : down : d.x > 0 ? right : left).push_back(length(d));
    }
    for (std::vector<double>* ray : {&up, &right, &down, &left}) {
        ASSERT_EQ(ray->size(), count / 4);
        std::sort(ray->begin(), ray->end());
        for (std::size_t i = 0; i < ray->size(); ++i)
            EXPECT_NEAR((*ray)[i], 2 * (double(i) + 0.5) / double(ray->size()), 1e-12);
    }
}

TEST(GlareDisplacement, FillsItsDiscWithoutRays) {
    int inner = 0;
    double farthest = 0;
    for (std::size_t k = 0; k < 256; ++k) {
        const dvec3 d = glare_displacement({.radius = 3}, {k, 256});
        EXPECT_EQ(d.z, 0);
        farthest = std::max(farthest, length(d));
        inner += length(d) < 1.5;
    }
    EXPECT_LT(farthest, 3);
    EXPECT_GT(farthest, 2.9);
    EXPECT_NEAR(inner, 64, 4);
}

}  // namespace
}  // namespace gw::multipass
