// The light that gw view shows of a lamp in candela: at its foot I / d^2, by the scene's white.
#include "apps/view/light_drawer.h"
#include "scene/draw/view.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace gw::apps {

TEST(LightWorker, KnowsLampsInCandela) {
    scene::Scene scene;
    radiosity::add_quad(scene, "floor", {-0.5, 0, -0.5}, {0, 0, 1}, {1, 0, 0}, 0.5f);
    scene.texels_per_unit = 5;
    scene.white = 100;
    scene.lights.push_back({.kind = scene::LightKind::Point,
                            .position = {0, 2, 0},
                            .luminous = scene::Luminous{dvec3(300), nullptr, 0}});
    scene.camera = scene::Camera{.eye = {0, 1, 0}, .at = {0, 0, 0}, .up = {0, 0, 1}};
    LightWorker worker(scene, {});
    worker.shoot_until(1e-6);  // all that the floor reflects escapes
    while (worker.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const Light light = worker.light();
    ASSERT_EQ(light.fault, "");
    LightDrawer drawer(1);
    const image::Picture picture = drawer.draw(light, scene::make_view(scene, 33, 33), vec3(0), 0);
    const double most = double((1 << picture.bits) - 1);
    EXPECT_NEAR(picture.values.at((16 * 33 + 16) * 3) / most, 0.5 * 300 / 4 / 100, 0.01);
}

}  // namespace gw::apps
