// Parts of patches beside surfaces that nothing hides: their near texels are in closed form.
#include "radiosity/hemicube/form_factors.h"
#include "tests/radiosity/oracle.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace gw::radiosity {
namespace {

/// Floor, left and back walls of a room, four patches long, open to the other sides.
scene::Scene corner() {
    scene::Scene scene;
    add_quad(scene, "floor", {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0.5f, 1);
    add_quad(scene, "left", {0, 0, 0}, {0, 2, 0}, {0, 0, 2}, 0.5f);
    add_quad(scene, "back", {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0.5f);
    return scene;
}

PixmapModel model_of(const scene::Scene& scene) {
    return make_model(scene, {.texels_per_unit = 8});
}

const Figure& figure_of(const PixmapModel& model, const std::string& name) {
    return *std::find_if(model.figures.begin(), model.figures.end(),
                         [&](const Figure& figure) { return figure.name == name; });
}

/// The patch that covers a point of a figure.
std::size_t patch_at(const PixmapModel& model, const std::string& name, const dvec3& p) {
    const std::uint32_t pixmap = figure_of(model, name).pixmap;
    const dvec2 uv = model.facets[model.pixmaps[pixmap].facets.front()].texel_of(p);
    for (std::size_t i = 0; i < model.patches.size(); ++i) {
        const Patch& patch = model.patches[i];
        if (patch.pixmap == pixmap && uv.x >= patch.x && uv.x < patch.x + patch.width &&
            uv.y >= patch.y && uv.y < patch.y + patch.height)
            return i;
    }
    ADD_FAILURE() << name << " has no patch there";
    return 0;
}

const PointOptions no_emitters{.emitter_part = 100};

Shooting shooting_at(const PixmapModel& model, const std::string& name, const dvec3& p) {
    return shooting_of(model, model.patches[patch_at(model, name, p)], no_emitters);
}

TEST(NearParts, LeavePatchesOfACornerWhole) {
    const PixmapModel model = model_of(corner());
    struct Expected {
        dvec3 at;
        std::size_t surfaces;
    };
    for (const auto& [at, surfaces] : {Expected{{0.25, 0, 0.25}, 2}, {{0.25, 0, 1.25}, 1}}) {
        const Shooting shooting = shooting_at(model, "floor", at);
        EXPECT_EQ(shooting.points.size(), 4);
        ASSERT_EQ(shooting.near_parts.size(), 4);
        for (const NearPart& part : shooting.near_parts) {
            EXPECT_EQ(part.texels.size(), surfaces);
            EXPECT_DOUBLE_EQ(part.share, 0.25);
        }
    }
    const Shooting middle = shooting_at(model, "floor", {1.25, 0, 1.25});
    EXPECT_TRUE(middle.near_parts.empty());
    EXPECT_EQ(middle.points.size(), 4);
}

/// Whether the patch beside the left wall, away from the back wall, is left whole.
bool is_left_whole(const scene::Scene& scene) {
    const Shooting shooting = shooting_at(model_of(scene), "floor", {0.25, 0, 1.25});
    return shooting.points.size() == 4 && shooting.near_parts.size() == 4;
}

bool is_left_whole_with(const vec3& at, const vec3& a, const vec3& b) {
    scene::Scene scene = corner();
    add_quad(scene, "plate", at, a, b);
    return is_left_whole(scene);
}

TEST(NearParts, AreDividedIfSomethingMayHideTheirTexels) {
    const vec3 along(0.1f, 0, 0), across(0, 0, 0.2f);
    EXPECT_TRUE(is_left_whole_with({1.5f, 0.5f, 1.5f}, across, along));  // far away
    EXPECT_FALSE(is_left_whole_with({0.1f, 0.1f, 1.1f}, across, along));
    EXPECT_FALSE(is_left_whole_with({0.1f, 0.1f, 1.1f}, along, across));  // its back
    EXPECT_TRUE(is_left_whole_with({0.1f, -0.1f, 1.1f}, along, across));  // under the floor
}

TEST(NearParts, AreDividedIfLightPassesBesideTheirTexels) {
    const auto with_wall = [](float height) {
        scene::Scene scene;
        add_quad(scene, "floor", {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0.5f, 1);
        add_quad(scene, "wall", {0, 0, 0}, {0, height, 0}, {0, 0, 2}, 0.5f);
        return scene;
    };
    EXPECT_TRUE(is_left_whole(with_wall(0.75f)));
    EXPECT_FALSE(is_left_whole(with_wall(0.25f)));
}

bool is_near(const Shooting& shooting, std::uint32_t facet, int u, int v) {
    for (const NearPart& part : shooting.near_parts)
        for (const NearTexels& texels : part.texels)
            if (texels.facet == facet && texels.contains(u, v)) return true;
    return false;
}

/// The form factors of a patch against sums of Lambert's formula over its points: to every texel.
void expect_exact(const PixmapModel& model, std::size_t number) {
    const Patch& patch = model.patches[number];
    const Facet& own = model.facets[model.pixmaps[patch.pixmap].facets.front()];
    const Shooting shooting = shooting_of(model, patch, no_emitters);
    FormFactors factors(model, {.hemicube = 256, .points = no_emitters});
    const Row row = factors.from_patch(number);
    EXPECT_EQ(row.hemicubes, 4);
    std::map<std::uint32_t, double> found;
    for (std::size_t i = 0; i < row.texels.size(); ++i) found[row.texels[i]] = row.factors[i];
    EXPECT_NEAR(
        std::accumulate(row.factors.begin(), row.factors.end(), 0.0) + row.backs + row.escaped, 1,
        1e-12);
    const Quad from{own.at(dvec2(patch.x, patch.y)), own.du * double(patch.width),
                    own.dv * double(patch.height)};
    for (std::uint32_t f = 0; f < model.facets.size(); ++f) {
        const Facet& facet = model.facets[f];
        if (facet.pixmap == patch.pixmap) continue;
        const Pixmap& pixmap = model.pixmaps[facet.pixmap];
        for (int v = 0; v < pixmap.height; ++v)
            for (int u = 0; u < pixmap.width; ++u) {
                const Quad to{facet.at(dvec2(u, v)), facet.du, facet.dv};
                const double exact = quad_to_quad(from, to, 60);
                const auto texel = static_cast<std::uint32_t>(pixmap.texel(u, v));
                // Gauss' four points are off where a texel is about as far as the patch is long.
                const double allowed = is_near(shooting, f, u, v) ? 0.005 : 0.04;
                EXPECT_NEAR(found[texel], exact, allowed * exact)
                    << pixmap.name << " " << u << " " << v;
            }
    }
}

TEST(NearParts, HaveExactFormFactorsToEveryTexelOfACorner) {
    const PixmapModel model = model_of(corner());
    expect_exact(model, patch_at(model, "floor", {0.25, 0, 0.25}));
    expect_exact(model, patch_at(model, "floor", {0.25, 0, 1.25}));
}

// A wall that stands on a larger floor: the floor behind it is not seen.
TEST(NearParts, DoNotSeeThroughTheSurfacesBesideThem) {
    scene::Scene scene;
    add_quad(scene, "floor", {-2, 0, 0}, {0, 0, 2}, {4, 0, 0}, 0.5f);
    add_quad(scene, "wall", {0, 0, 0}, {0, 2, 0}, {0, 0, 2}, 0.5f, 1);
    const PixmapModel model = model_of(scene);
    const std::size_t patch = patch_at(model, "wall", {0, 0.25, 1.25});
    ASSERT_EQ(shooting_of(model, model.patches[patch], no_emitters).near_parts.size(), 4);
    const Row row = FormFactors(model, {.hemicube = 64, .points = no_emitters}).from_patch(patch);
    const Pixmap& floor = model.pixmaps[figure_of(model, "floor").pixmap];
    const Facet& facet = model.facets[floor.facets.front()];
    for (const std::uint32_t t : row.texels) {
        const auto i = static_cast<int>(t - floor.first);
        EXPECT_GT(facet.at({i % floor.width + 0.5, i / floor.width + 0.5}).x, 0);
    }
}

/// A box without a bottom on a floor, whose sides cross its texels.
scene::Scene box_on_floor() {
    scene::Scene scene;
    add_quad(scene, "floor", {0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0.5f, 1);
    const vec3 a(0.9f, 0, 0.3f), b(0.3f, 0, -0.9f), up(0, 0.5f, 0), at(0.4f, 0, 1.2f);
    add_quad(scene, "side", at, a, up, 0.5f);
    add_quad(scene, "side", at + a, b, up, 0.5f);
    add_quad(scene, "side", at + a + b, -a, up, 0.5f);
    add_quad(scene, "side", at + b, -b, up, 0.5f);
    add_quad(scene, "top", at + up, a, b, 0.5f);
    return scene;
}

TEST(Patches, AreSingleTexelsWhereSomethingStandsOnThem) {
    const PixmapModel model = model_of(box_on_floor());
    const std::uint32_t floor = figure_of(model, "floor").pixmap;
    double area = 0;
    for (const Patch& patch : model.patches) area += patch.pixmap == floor ? patch.area : 0;
    EXPECT_NEAR(area, 4, 1e-6);
    const auto size_at = [&](const dvec3& p) {
        return model.patches[patch_at(model, "floor", p)].width;
    };
    for (const double along : {0.1, 0.3, 0.7, 0.9})
        EXPECT_EQ(size_at({0.4 + 0.9 * along, 0, 1.2 + 0.3 * along}), 1) << along;
    EXPECT_EQ(size_at({0.1, 0, 0.1}), 4);
}

// The points under the box see nothing but the backs of its sides. Their light comes from the others.
TEST(FormFactors, OfAPatchUnderTheBorderOfABoxLoseNothingInIt) {
    const PixmapModel model = model_of(box_on_floor());
    FormFactors factors(model, {.hemicube = 64, .points = no_emitters});
    int cut = 0;
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        if (model.patches[p].pixmap != figure_of(model, "floor").pixmap) continue;
        const Row row = factors.from_patch(p);
        cut += row.backs == 0 && model.patches[p].width == 1 ? 1 : 0;
        EXPECT_TRUE(row.backs == 0 || std::abs(row.backs - 1) < 1e-9) << row.backs;
    }
    EXPECT_GT(cut, 20);
    const Row under = factors.from_patch(patch_at(model, "floor", {0.9, 0, 0.9}));
    EXPECT_NEAR(under.backs, 1, 1e-9);
}

}  // namespace
}  // namespace gw::radiosity
