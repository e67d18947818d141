// Rays from the item buffer start inside their polygon: no pixel loses an interface of glass.
#include "itembuffer/render.h"
#include "itembuffer/superposed_ray_tracer.h"
#include "raytrace/tracer/render.h"
#include "scene/draw/item_buffer.h"
#include "scene/geometry/transform.h"
#include "scene/shapes/shapes.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gw::itembuffer {
namespace {

constexpr int width = 160, height = 120;

/// A glass before a wall of one colour, so that only lost interfaces make pixels differ.
scene::Scene glass() {
    raytrace::Walls walls;
    for (const float z : {-4.0f, 7.0f})
        walls.add_shining({0, 0, z}, {z < 0 ? 9.0f : -9.0f, 0, 0}, {0, 9, 0},
                          {z < 0 ? 0.8f : 0.1f, 0.5f, 0.2f});
    std::uint32_t next = 2;
    walls.scene.objects.push_back(
        {.name = "glass",
         .mesh = scene::make_numbered_mesh(scene::make_cylinder(1, 2.2, 48, 24, true), next),
         .material = walls.scene.materials.size(),
         .world_from_object = scene::rotation({1, 0, 0}, 25)});
    walls.scene.materials.push_back(
        {.Ka = vec3(0), .Kd = vec3(0), .Ks = vec3(0.04f), .Ni = 1.5f, .d = 0.05f, .illum = 7});
    walls.scene.camera->fov = 35;
    return walls.scene;
}

TEST(TracedComponent, HasNoSpecksOnGlass) {
    const scene::Scene s = glass();
    const scene::View view = scene::make_view(s, width, height);
    const auto machine = make_fast(vgx(), width, height);
    render(*machine, s, view, {}, {.depth = 8});
    const std::vector<Rgba> passes = machine->planes().color;
    const auto ids = scene::draw_item_buffer(*machine, raytrace::drawn_scene(s), view, {});
    const raytrace::World world(s);
    const raytrace::Tracer tracer(s, world, view, {.depth = 8});
    const auto rays = raytrace::raytraced_picture(tracer, s, view, {}, vgx());
    int specks = 0, shown = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] != rays.ids[i] || ids[i] < 3) continue;
        ++shown;
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(int(passes[i][c]) - int(rays.color[i][c])));
        specks += most > 40;
    }
    EXPECT_GT(shown, 1000);
    EXPECT_EQ(specks, 0) << "of " << shown;
}

}  // namespace
}  // namespace gw::itembuffer
