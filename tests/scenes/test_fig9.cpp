// Fig. 9's class of scene [K4f]: 444 matte and 77,184 glossy polygons, about a third of the pixels
// glossy.
#include "gw/machine.h"
#include "multipass/frame/driver.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace gw::scene {
namespace {

Scene fig9() {
    return read_scene(std::filesystem::path(GW_SOURCE_DIR) / "scenes" / "fig9.toml").scene;
}

bool glossy(const Material& m) { return m.illum >= 3; }

TEST(Fig9, HasExactly444MatteAnd77184GlossyPolygons) {
    const Scene scene = fig9();
    std::uint32_t matte_polygons = 0, glossy_triangles = 0;
    std::set<std::string> glossy_objects;
    for (const Object& object : scene.objects) {
        const Material& material = scene.materials[object.material];
        if (glossy(material)) {
            EXPECT_GT(std::max({material.Ks.x, material.Ks.y, material.Ks.z}), 0.0f);
            EXPECT_EQ(object.mesh->polygon_count(), object.mesh->triangles().size());
            glossy_triangles += object.mesh->polygon_count();
            glossy_objects.insert(object.name);
        } else {
            EXPECT_EQ(material.Ks, vec3(0));
            EXPECT_TRUE(material.refl.empty());
            matte_polygons += object.mesh->polygon_count();
        }
    }
    EXPECT_EQ(matte_polygons, 444u);
    EXPECT_EQ(glossy_triangles, 77184u);
    EXPECT_EQ(glossy_objects.size(), 12u);
}

// Draws glossy objects white, the rest black, and counts.
TEST(Fig9, AboutAThirdOfItsPixelsIsGlossy) {
    Scene scene = fig9();
    for (Material& material : scene.materials)
        material = {.Ka = vec3(0),
                    .Kd = vec3(0),
                    .Ke = vec3(glossy(material) ? 1 : 0),
                    .illum = material.illum};
    const auto machine = make_fast(vgx(), 640, 480);
    multipass::render(*machine, scene, make_view(scene, 640, 480), {});
    const auto white =
        std::ranges::count_if(machine->planes().color, [](const Rgba& c) { return c[0] == 255; });
    EXPECT_NEAR(static_cast<double>(white) / (640 * 480), 1.0 / 3, 0.02);
}

}  // namespace
}  // namespace gw::scene
