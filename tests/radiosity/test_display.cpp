// Pictures of pixmaps [F2.3]: strips refer to every texel and leave no gaps, charts meet without a
// seam, glowing scenes.
#include "gw/machine.h"
#include "radiosity/display/emissive_scene.h"
#include "scene/draw/draw_commands.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace gw::radiosity {
namespace {

MeshRef sphere(int slices, int stacks) {
    const auto& shapes = scene::shapes();
    const auto shape = std::find_if(shapes.begin(), shapes.end(),
                                    [](const auto& s) { return s.name == "sphere"; });
    std::vector<double> values;
    for (const auto& p : shape->parameters)
        values.push_back(p.name == "radius" ? 1 : p.name == "slices" ? slices : stacks);
    std::uint32_t next = 0;
    return scene::make_numbered_mesh(shape->make(values), next);
}

scene::Scene with(MeshRef mesh) {
    scene::Scene scene;
    scene.materials.push_back({.name = "matter", .Kd = vec3(0.5f), .Ke = vec3(1)});
    scene.objects.push_back({.name = "thing", .mesh = std::move(mesh)});
    return scene;
}

const scene::View view =
    scene::make_view({.eye = {0.3, 0.4, 5}}, scene::Bounds{dvec3(-1), dvec3(1), false}, 64, 64);

/// Every colour of a vertex in a list.
std::vector<vec4> vertex_colors(const CommandList& list) {
    std::vector<vec4> all;
    for (const Command& command : list.commands)
        if (const auto* draw = std::get_if<Draw>(&command))
            all.insert(all.end(), draw->mesh->data().colors.begin(),
                       draw->mesh->data().colors.end());
    return all;
}

/// Whether one texel alone being bright brightens a vertex.
void expect_every_texel_in_strips(const PixmapModel& model) {
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p)
        for (int y = 0; y < model.pixmaps[p].height; ++y)
            for (int x = 0; x < model.pixmaps[p].width; ++x) {
                const std::size_t t = model.pixmaps[p].texel(x, y);
                if (model.nearest[t] != t || model.area[t] == 0) continue;
                DisplayedPixmaps colors(model);
                colors.at(p, x, y) = dvec3(1);
                const std::vector<vec4> vertices =
                    vertex_colors(strip_list(model, colors, view, {}, 1));
                EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(),
                                        [](const vec4& c) { return c.x > 0; }))
                    << model.pixmaps[p].name << " " << x << " " << y;
            }
}

TEST(Strips, ReferToEveryTexelOfABox) {
    expect_every_texel_in_strips(
        make_model(closed_box({1, 0.6f, 1.3f}, 0.5f, 1), {.texels_per_unit = 5}));
}

TEST(Strips, ReferToEveryTexelOfATriangle) {
    const MeshData triangle{.positions = {{0, 0, 0}, {0.3f, 0, 2.2f}, {1.7f, 0, 0.4f}}};
    expect_every_texel_in_strips(make_model(with(make_mesh(triangle)), {.texels_per_unit = 4}));
}

TEST(Strips, ReferToEveryTexelOfASphere) {
    expect_every_texel_in_strips(make_model(with(sphere(12, 6)), {.texels_per_unit = 3}));
}

// Sides that triangles share have the same vertices, whatever the resolutions at both sides: no
// pixel between them shows what is behind. From within a closed box nothing else can be seen.
TEST(Strips, LeaveNoGaps) {
    scene::Scene scene = closed_box({2, 2, 2}, 0.5f, 1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects[i].pixmap.texels_per_unit = 2.5 + 1.7 * double(i);
    const PixmapModel model = make_model(scene);
    DisplayedPixmaps colors(model);
    const scene::View inside = scene::make_view(
        {.eye = {0.61, 0.93, 0.77}, .at = {2, 0.1, 2}, .fov = 100}, scene::bounds(scene), 256, 256);
    const auto machine = make_fast(ideal(), 256, 256, {.threads = 1});
    machine->execute(figures_of(strip_list(model, colors, inside, {}, 1)));
    const auto& pixels = machine->planes().color;
    EXPECT_EQ(std::count_if(pixels.begin(), pixels.end(),
                            [](const Rgba& c) { return scene::id_of(c) == 0; }),
              0);
}

/// The largest difference of colours at vertices that several charts share.
double seam(const PixmapModel& model, const DisplayedPixmaps& colors) {
    std::map<std::array<float, 3>, std::vector<double>> at;
    const Mesh& mesh = *model.drawn.objects[0].mesh;
    for (const Triangle& t : mesh.triangles()) {
        const Facet& facet = model.facets[mesh.polygon_id(t.polygon)];
        for (std::uint32_t v : t.vertex) {
            const vec3& p = mesh.data().positions[v];
            at[{p.x, p.y, p.z}].push_back(colors.at(facet.pixmap, facet.texel_of(dvec3(p))).x);
        }
    }
    double worst = 0;
    for (const auto& [p, values] : at) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        worst = std::max(worst, *high - *low);
    }
    return worst;
}

// A sphere lit from above, bright 0 to 1. Where each chart's border repeats its own texels, a seam
// is as large as the light changes in a texel; where it shows the neighbour's, a fraction of that.
TEST(Seams, ChartsOfASphereMeet) {
    const PixmapModel model = make_model(with(sphere(24, 12)), {.texels_per_unit = 6});
    ASSERT_GT(model.pixmaps.size(), 4u);
    Solution solution = initial_solution(model);
    for (std::uint32_t number = 0; number < model.facets.size(); ++number) {
        const Facet& facet = model.facets[number];
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        for (int y = int(facet.low.y); y < std::min(pixmap.height, int(facet.high.y) + 1); ++y)
            for (int x = int(facet.low.x); x < std::min(pixmap.width, int(facet.high.x) + 1); ++x)
                // times Kd
                solution.H[pixmap.texel(x, y)] = dvec3(facet.at({x + 0.5, y + 0.5}).y + 1);
    }
    DisplayedPixmaps repeated(model);
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p)
        for (int y = -1; y <= model.pixmaps[p].height; ++y)
            for (int x = -1; x <= model.pixmaps[p].width; ++x)
                repeated.at(p, x, y) =
                    radiosity_at(model, solution,
                                 model.nearest[model.pixmaps[p].texel(
                                     std::clamp(x, 0, model.pixmaps[p].width - 1),
                                     std::clamp(y, 0, model.pixmaps[p].height - 1))]);
    const double open = seam(model, repeated),
                 closed = seam(model, displayed_pixmaps(model, solution, false));
    EXPECT_GT(open, 0.06);
    EXPECT_LT(closed, open / 2);
}

TEST(Glow, EmitsRadiosityAndKeepsHighlights) {
    scene::Scene scene = closed_box({1, 1, 1}, 0.5f, 1);
    scene.materials[0].Ks = vec3(0.25f);
    scene.lights.push_back({.name = "lamp", .Is = vec3(1)});
    const PixmapModel model = make_model(scene, {.texels_per_unit = 4});
    const scene::Scene glow =
        emissive_scene(scene, model, displayed_pixmaps(model, initial_solution(model), false), 0.5);
    ASSERT_EQ(glow.objects.size(), 6u);
    const scene::Material& m = glow.materials[glow.objects[0].material];
    EXPECT_EQ(m.Kd, vec3(0));
    EXPECT_EQ(m.Ks, vec3(0.25f));
    ASSERT_EQ(m.map_Ke.size(), 1u);
    EXPECT_EQ(m.map_Ke[0].texture->levels.front().rgba[0], 32768);  // E = 1, halved
    EXPECT_EQ(*glow.lights[0].Is, vec3(0.5f));
}

// A room is looked into from outside: its wall before the eye is not drawn, the others are.
TEST(Glow, BacksAreLeftOutAndIdentifiersStay) {
    const scene::Scene scene = closed_box({2, 2, 2}, 0.5f, 1);
    const PixmapModel model = make_model(scene, {.texels_per_unit = 2});
    const scene::Scene glow =
        emissive_scene(scene, model, displayed_pixmaps(model, initial_solution(model), false), 1);
    const scene::Scene seen = without_backs(glow, {.eye = {1, 1, 8}, .at = {1, 1, 0}});
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(seen.objects[i].mesh->polygon_count(), glow.objects[i].mesh->polygon_count());
        const auto& p = seen.objects[i].mesh->data().positions;
        EXPECT_EQ(p[0] == p[1], seen.objects[i].name == "front") << seen.objects[i].name;
    }
}

}  // namespace
}  // namespace gw::radiosity
