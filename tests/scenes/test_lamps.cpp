#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace gw::scenes {
namespace {

const std::filesystem::path file = std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "lamps.toml";

TEST(Lamps, AreAHundredOfThemTwelveWithShadows) {
    const scene::Scene scene = scene::read_scene(file).scene;
    EXPECT_EQ(scene.lights.size(), 100u);
    const auto casts = [](const scene::Light& l) { return l.shadow != scene::Shadow::None; };
    EXPECT_EQ(std::ranges::count_if(scene.lights, casts), 12);
    for (const scene::Light& l : scene.lights) {
        EXPECT_EQ(l.kind, scene::LightKind::Point) << l.name;
        EXPECT_GT(l.quadratic_attenuation, 0) << l.name;
    }
}

}  // namespace
}  // namespace gw::scenes
