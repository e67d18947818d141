// Claims of light maps: no texel serves two charts, with bilinear filters at the borders too; each
// texel has the bits of the solution's colour; every triangle looks up its own pixmap.
#include "radiosity/display/light_atlas.h"
#include "radiosity/solver/solver.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gw::radiosity {
namespace {

/// A closed room with a ball, whose surface has several charts.
scene::Scene room() {
    scene::Scene scene = closed_box({2, 3, 2.5f}, 0.5f, 0);
    scene.materials[1].Ke = vec3(1, 0.75f, 0.5f);
    const auto& shapes = scene::shapes();
    const auto shape = std::find_if(shapes.begin(), shapes.end(),
                                    [](const auto& s) { return s.name == "icosphere"; });
    std::vector<double> values;
    for (const auto& p : shape->parameters) values.push_back(p.name == "radius" ? 0.5 : 2);
    std::uint32_t next = 0;
    scene.materials.push_back({.name = "clay", .Kd = vec3(0.7f)});
    dmat4 placed(1);
    placed[3] = dvec4(1, 1.4, 1.2, 1);
    scene.objects.push_back({.name = "ball",
                             .mesh = scene::make_numbered_mesh(shape->make(values), next),
                             .material = scene.materials.size() - 1,
                             .world_from_object = placed});
    return scene;
}

PixmapModel model_of(const scene::Scene& scene) {
    return make_model(scene, {.texels_per_unit = 4});
}

std::size_t pages_used(const LightAtlas& atlas) {
    std::size_t last = 0;
    for (const AtlasPlace& place : atlas.places) last = std::max(last, place.page);
    return last + 1;
}

}  // namespace

TEST(LightAtlas, NoTexelServesTwoPixmaps) {
    const scene::Scene scene = room();
    const PixmapModel model = model_of(scene);
    ASSERT_GT(model.pixmaps.size(), 8u);
    for (const int most_side : {4096, 32, 16}) {
        const LightAtlas atlas = make_atlas(model, most_side);
        EXPECT_EQ(atlas.pages.size(), pages_used(atlas));
        EXPECT_EQ(atlas.pages.size() > 1, most_side < 4096);
        std::map<std::array<int, 3>, std::uint32_t> owner;
        for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p) {
            const AtlasPlace& at = atlas.places[p];
            for (int y = 0; y < model.pixmaps[p].height + 2; ++y)
                for (int x = 0; x < model.pixmaps[p].width + 2; ++x) {
                    EXPECT_LT(at.x + x, atlas.pages[at.page].width);
                    EXPECT_LT(at.y + y, atlas.pages[at.page].height);
                    EXPECT_TRUE(owner.try_emplace({int(at.page), at.x + x, at.y + y}, p).second);
                }
        }
    }
}

TEST(LightAtlas, TrianglesReadOnlyTexelsOfTheirOwnPixmap) {
    const scene::Scene scene = room();
    const PixmapModel model = model_of(scene);
    const LightAtlas atlas = make_atlas(model);
    const std::vector<AtlasMesh> meshes = atlas_meshes(atlas, scene, model);
    ASSERT_EQ(meshes.size(), model.sources.size());
    std::map<std::pair<int, int>, std::uint32_t> owner;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        std::size_t corner = 0;
        for (const std::uint32_t facet : model.sources[m].facets) {
            if (facet == no_facet) continue;
            dvec2 low(1e9), high(-1e9);
            for (const std::size_t end = corner + 3; corner < end; ++corner) {
                const dvec2 at = dvec2(meshes[m].st[corner]) *
                                 dvec2(atlas.pages[0].width, atlas.pages[0].height);
                for (int k = 0; k < 2; ++k) {
                    low[k] = std::min(low[k], at[k] + 1e-3);
                    high[k] = std::max(high[k], at[k] - 1e-3);
                }
            }
            for (int y = int(std::floor(low.y - 0.5)); y <= int(std::floor(high.y + 0.5)); ++y)
                for (int x = int(std::floor(low.x - 0.5)); x <= int(std::floor(high.x + 0.5)); ++x)
                    EXPECT_EQ(owner.try_emplace({x, y}, model.facets[facet].pixmap).first->second,
                              model.facets[facet].pixmap);
        }
        EXPECT_EQ(corner, meshes[m].st.size());
    }
}

/// In a box no smooth surface continues in another pixmap, so pictures show the radiosity itself.
TEST(LightAtlas, TexelsHaveTheBitsOfTheSolution) {
    scene::Scene scene = closed_box({2, 3, 2.5f}, 0.5f, 0);
    scene.materials[1].Ke = vec3(1, 0.75f, 0.5f);
    Solver solver(model_of(scene), {});
    for (int i = 0; i < 5; ++i) solver.shoot();
    const PixmapModel& model = solver.model();
    const LightAtlas atlas = make_atlas(model, 16);
    ASSERT_GT(atlas.pages.size(), 1u);
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p) {
        const AtlasPlace& at = atlas.places[p];
        const std::vector<float> page =
            page_colors(atlas, at.page, model, displayed_pixmaps(model, solver.solution(), false));
        const auto width = std::size_t(atlas.pages[at.page].width);
        const Pixmap& pixmap = model.pixmaps[p];
        for (int y = -1; y <= pixmap.height; ++y)
            for (int x = -1; x <= pixmap.width; ++x) {
                const std::size_t t = pixmap.texel(std::clamp(x, 0, pixmap.width - 1),
                                                   std::clamp(y, 0, pixmap.height - 1));
                const dvec3 B = radiosity_at(model, solver.solution(), t);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(
                        page[(std::size_t(at.y + 1 + y) * width + std::size_t(at.x + 1 + x)) * 3 +
                             c],
                        float(B[int(c)]));
            }
    }
}

TEST(LightAtlas, CornersLieWhereTheSceneHasThem) {
    const scene::Scene scene = room();
    const PixmapModel model = model_of(scene);
    for (const AtlasMesh& mesh : atlas_meshes(make_atlas(model), scene, model)) {
        const scene::Object& object = scene.objects[mesh.object];
        const dvec3 moved(object.world_from_object[3]);
        for (const vec3& p : mesh.positions) {
            const auto& own = object.mesh->data().positions;
            EXPECT_TRUE(std::any_of(own.begin(), own.end(), [&](const vec3& q) {
                return vec3(dvec3(q) + moved) == p;
            })) << object.name;
        }
    }
}

}  // namespace gw::radiosity
