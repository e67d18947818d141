// Claims: polygons whose thin triangles turn around in the snap are named, others are not.
#include "scene/validate/slivers.h"

#include <gtest/gtest.h>

namespace gw::scene {
namespace {

/// An outline of this many corners on each of four lines, which lie between the axes.
Scene outline(int on_a_line) {
    constexpr std::array<dvec2, 5> at{{{0, 0}, {4, 0.3}, {4.5, 3}, {1, 4}, {0, 0}}};
    MeshData data{.primitive = Primitive::Polygons};
    for (std::size_t line = 0; line < 4; ++line)
        for (int k = 0; k < on_a_line; ++k) {
            const dvec2 p = at[line] + (at[line + 1] - at[line]) * (double(k) / on_a_line);
            data.positions.emplace_back(p.x, p.y, 0);
        }
    Scene scene;
    scene.materials.push_back({.name = "paint"});
    scene.objects.push_back({.name = "plate", .mesh = make_mesh(std::move(data))});
    scene.camera = Camera{.eye = {3.2, 1.8, 6}, .at = {2.2, 1.8, 0}};
    return scene;
}

constexpr int vgx_bits = 3;

std::string named(const Scene& scene, int bits) {
    return turned_slivers(scene, make_view(scene, 320, 240), bits);
}

}  // namespace

TEST(TurnedSlivers, AreThoseOfManyCornersOnALine) {
    EXPECT_EQ(named(outline(50), vgx_bits),
              "object 'plate' has a polygon with 200 corners, so many on a line that pixels there "
              "may have the colour of its back; expected fewer on a line, or a renderer by rays");
    EXPECT_EQ(named(outline(1), vgx_bits), "");
    EXPECT_EQ(named(outline(2), vgx_bits), "");
}

/// A polygon whose corners behind the eye make no window coordinates.
TEST(TurnedSlivers, NeedCornersBeforeTheEye) {
    Scene scene = outline(50);
    scene.camera->eye = {2.2, 1.8, 0.01};
    scene.camera->at = {2.2, 3, 0.01};
    EXPECT_EQ(named(scene, vgx_bits), "");
}

}  // namespace gw::scene
