// Claims: what a mask or a single-sided material hides is hidden in every renderer: a masked wall is the
// picture of the wall that is left, and a wall whose back is seen is the picture without it, but for its
// shadow. The alpha of maps of colours is no opacity. Mirrored objects are lit from outside.
#include "render/drawing.h"
#include "scene/maps/finish.h"
#include "scene/shapes/shapes.h"
#include "tests/raytrace/walls.h"

#include <gtest/gtest.h>

#include <utility>

namespace gw::render {
namespace {

constexpr int side = 48;

/// A lit wall, and before it what `add` adds.
template <class Add>
scene::Scene room(const Add& add, scene::Shadow shadow = scene::Shadow::None) {
    raytrace::Walls walls;
    scene::Material& back = walls.add({0, 0, -2}, {3, 0, 0}, {0, 3, 0});
    back.Kd = vec3(0.2f, 0.7f, 0.3f);
    walls.scene.lights.push_back(
        {.name = "sun", .direction = {-0.3f, -0.2f, -1}, .shadow = shadow});
    add(walls);
    return walls.scene;
}

std::vector<Rgba> picture(scene::Scene scene, const std::string& renderer) {
    scene::Warnings warnings;
    scene::finish(scene, warnings);
    const Request request{.renderer = renderer, .size = {side, side}, .threads = 1};
    const Drawing drawing = make_drawing(request, vgx(), {.scene = std::move(scene)});
    const auto machine = make_machine(request, drawing.profile);
    draw(drawing, drawing.view(), *machine);
    return machine->planes().color;
}

/// From x = low to 1, unit high, at z = 0, with s from its left to its right.
scene::Material& add_pane(raytrace::Walls& walls, float low, float alpha_left) {
    scene::Material& m = walls.add({(low + 1) / 2, 0, 0}, {(1 - low) / 2, 0, 0}, {0, 1, 0});
    m.Kd = vec3(0.8f, 0.3f, 0.2f);
    MeshData data = walls.scene.objects.back().mesh->data();
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    walls.scene.objects.back().mesh = make_mesh(std::move(data));
    const auto left = std::uint16_t(alpha_left * 65535);
    std::vector<std::uint16_t> rgba;
    for (int i = 0; i < 4; ++i)
        rgba.insert(rgba.end(), {0xFFFF, 0xFFFF, 0xFFFF, i < 2 ? left : std::uint16_t(0xFFFF)});
    m.map_Kd = m.map_d = {scene::Map{
        .wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .texture = make_texture("half", 4, 1, rgba)}};
    return m;
}

std::size_t differences(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
    return count;
}

}  // namespace

TEST(MasksAndSides, AMaskedWallIsTheWallThatIsLeft) {
    for (const scene::Shadow shadow :
         {scene::Shadow::None, scene::Shadow::Volume, scene::Shadow::Map})
        for (const Renderer& renderer : renderers()) {
            const auto masked =
                picture(room([](raytrace::Walls& walls) { add_pane(walls, -1, 0).d_cutoff = 0.5f; },
                             shadow),
                        renderer.name);
            const auto plain = picture(room(
                                           [](raytrace::Walls& walls) {
                                               scene::Material& m = add_pane(walls, 0, 1);
                                               m.map_d.clear();
                                           },
                                           shadow),
                                       renderer.name);
            EXPECT_EQ(differences(masked, plain), 0u) << renderer.name << " " << int(shadow);
            const auto whole = picture(
                room([](raytrace::Walls& walls) { add_pane(walls, -1, 1).map_d.clear(); }, shadow),
                renderer.name);
            EXPECT_GT(differences(masked, whole), 50u) << renderer.name;
        }
}

TEST(MasksAndSides, AMapOfOpacityIsTheWallsOfItsOpacities) {
    const auto wall = [](float low, float high, float d) {
        return [=](raytrace::Walls& walls) {
            scene::Material& m =
                walls.add({(low + high) / 2, 0, 0}, {(high - low) / 2, 0, 0}, {0, 1, 0});
            m.Kd = vec3(0.8f, 0.3f, 0.2f);
            m.d = d;
        };
    };
    for (const Renderer& renderer : renderers()) {
        const auto cut = picture(room([](raytrace::Walls& walls) {
                                     scene::Material& m = add_pane(walls, -1, 0.5f);
                                     m.d = 0.5f;
                                 }),
                                 renderer.name);
        const auto left = picture(room(wall(-1, 0, 0.25f)), renderer.name),
                   right = picture(room(wall(0, 1, 0.5f)), renderer.name);
        // Between the middles of the texels of both, from -0.25 to 0.25, opacities lie between.
        std::size_t steps = 0;
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t i = y * side + x;
                const bool is_left = x < side / 2, is_between = x >= 18 && x < side - 18;
                const Rgba& expected = (is_left ? left : right)[i];
                if (is_between)
                    steps += cut[i] != expected;
                else
                    EXPECT_EQ(cut[i], expected) << renderer.name << x << " " << y;
            }
        const bool blends = left[side / 2 * side + 14] != right[side / 2 * side + 33];
        if (blends) {
            EXPECT_GT(steps, 20u) << renderer.name;
        }
    }
}

TEST(MasksAndSides, TheAlphaOfAMapOfColoursIsNoOpacity) {
    const auto with_map = [](float alpha, float d, bool is_sphere_map) {
        return room([=](raytrace::Walls& walls) {
            scene::Material& m = add_pane(walls, -1, alpha);
            m.map_d.clear();
            m.d = d;
            if (!is_sphere_map) return;
            m.Ks = vec3(0.5f);
            m.refl = std::exchange(m.map_Kd, {});
        });
    };
    // Passes of opaque surfaces leave a map's alpha in that of the frame buffer.
    const auto seen = [](std::vector<Rgba> picture) {
        for (Rgba& color : picture) color[3] = 0;
        return picture;
    };
    for (const Renderer& renderer : renderers())
        for (const bool is_sphere_map : {false, true})
            for (const float d : {0.5f, 1.0f}) {
                const auto plain = picture(with_map(1, d, is_sphere_map), renderer.name),
                           with_alpha = picture(with_map(0.25f, d, is_sphere_map), renderer.name);
                EXPECT_EQ(differences(seen(with_alpha), seen(plain)), 0u)
                    << renderer.name << d << is_sphere_map;
            }
}

TEST(MasksAndSides, TheBackOfASingleSidedWallIsNotDrawn) {
    const auto with_wall = [](bool turned, bool mirrored) {
        return room([&](raytrace::Walls& walls) {
            // [GLTF2 3.7.4]: mirroring does not turn a face inside out.
            const vec3 u(turned ? -1.0f : 1.0f, 0, 0);
            walls.add({0, 0, 0}, u, {0, 1, 0}).Kd = vec3(0.5f);
            walls.scene.objects.back().single_sided = true;
            if (mirrored) walls.scene.objects.back().world_from_object[0].x = -1;
        });
    };
    const auto without = room([](raytrace::Walls&) {});
    const auto double_sided = room([](raytrace::Walls& walls) {
        walls.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).Kd = vec3(0.5f);
    });
    for (const Renderer& renderer : renderers())
        for (const bool mirrored : {false, true}) {
            const auto nothing = picture(without, renderer.name);
            EXPECT_EQ(differences(picture(with_wall(true, mirrored), renderer.name), nothing), 0u)
                << renderer.name << mirrored;
            EXPECT_EQ(differences(picture(with_wall(false, mirrored), renderer.name),
                                  picture(double_sided, renderer.name)),
                      0u)
                << renderer.name << mirrored;
        }
}

// A lamp on the axis of the mirror lights both halves alike.
TEST(MasksAndSides, AMirroredBallIsLitAsItsImage) {
    const auto ball = [](float x) {
        scene::Scene scene = room([](raytrace::Walls&) {});
        scene.lights = {
            {.name = "lamp", .kind = scene::LightKind::Point, .position = {0, 0.5f, 3}}};
        scene.materials.push_back({.name = "ball", .Ks = vec3(0.5f), .Ns = 20});
        scene.objects.push_back(
            {.name = "ball", .mesh = make_mesh(scene::make_sphere(1, 32, 16)), .material = 1});
        scene.objects.back().world_from_object =
            dmat4(x < 0 ? -0.5 : 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, double(x), 0, 0, 1);
        return scene;
    };
    for (const Renderer& renderer : renderers()) {
        const auto plain = picture(ball(0.6f), renderer.name),
                   mirrored = picture(ball(-0.6f), renderer.name);
        std::size_t off = 0;
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const Rgba &a = plain[y * side + x], &b = mirrored[y * side + side - 1 - x];
                for (std::size_t k = 0; k < 3; ++k) off += std::abs(int(a[k]) - int(b[k])) > 3;
            }
        EXPECT_LT(off, 3 * 20u) << renderer.name;  // along the silhouette
    }
}

TEST(MasksAndSides, ASingleSidedWallCastsItsShadowFromBothSides) {
    const auto with_wall = [](bool turned, scene::Shadow shadow) {
        return room(
            [&](raytrace::Walls& walls) {  // beside the view, so that only its shadow is seen
                walls.add({1.5f, 1, 3}, {turned ? -0.7f : 0.7f, 0, 0}, {0, 0.7f, 0});
                walls.scene.objects.back().single_sided = true;
            },
            shadow);
    };
    for (const scene::Shadow shadow : {scene::Shadow::Volume, scene::Shadow::Map})
        for (const std::string renderer : {"multipass", "raytrace"}) {
            const auto front = picture(with_wall(false, shadow), renderer);
            EXPECT_EQ(differences(front, picture(with_wall(true, shadow), renderer)), 0u)
                << renderer << int(shadow);
            EXPECT_GT(differences(front, picture(room([](raytrace::Walls&) {}, shadow), renderer)),
                      50u)
                << renderer << int(shadow);
        }
}

}  // namespace gw::render
