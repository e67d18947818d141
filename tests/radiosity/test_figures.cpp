// Figures, ST and pixmaps [F2.1].
#include "gw/error.h"
#include "radiosity/model/figures.h"
#include "tests/radiosity/scenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

namespace gw::radiosity {
namespace {

double area(const PixmapModel& model) {
    return std::accumulate(model.area.begin(), model.area.end(), 0.0);
}

scene::Scene one(MeshData mesh, scene::PixmapChoice pixmap = {}, float rho = 0.5f) {
    scene::Scene scene;
    scene.materials.push_back({.name = "matter", .Kd = vec3(rho), .Ke = vec3(1)});
    scene.objects.push_back(
        {.name = "thing", .mesh = make_mesh(std::move(mesh)), .pixmap = std::move(pixmap)});
    return scene;
}

MeshData square() {
    return {.primitive = Primitive::Quads,
            .positions = {{0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}},
            .texcoords = {{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
}

scene::PixmapChoice given(int width, int height, std::string name = "") {
    return {.name = std::move(name), .width = width, .height = height, .given_st = true};
}

TEST(Figures, AnAutomaticRectangleHasWholeTexelsOnly) {
    const PixmapModel model = make_model(one(square()), {.texels_per_unit = 3.1});
    ASSERT_EQ(model.pixmaps.size(), 1u);
    EXPECT_EQ(model.pixmaps[0].width, 7);
    EXPECT_EQ(model.pixmaps[0].height, 7);
    EXPECT_EQ(model.facets.size(), 1u);
    for (double a : model.area) EXPECT_NEAR(a, 4.0 / 49, 1e-12);
}

TEST(Figures, ABoxHasSixPixmapsAndOneFacetEach) {
    EXPECT_EQ(make_model(closed_box({1, 2, 3}, 0, 1)).facets.size(), 6u);
}

// A triangle's border cuts texels: they count by what is covered.
TEST(Figures, BorderTexelsCountByTheirCoveredArea) {
    const MeshData triangle{.positions = {{0, 0, 0}, {0, 0, 4}, {4, 0, 0}}};
    const PixmapModel model = make_model(one(triangle), {.texels_per_unit = 1});
    EXPECT_NEAR(area(model), 8, 1e-9);
}

// ST rotated by an angle with cos 0.8, sheared, mirrored: the area stays, and so does the way back
// from space to texel.
TEST(Figures, STMayBeRotatedShearedAndMirrored) {
    const std::vector<std::function<vec2(vec2)>> maps{
        [](vec2 s) {
            return vec2(0.5f) + 0.5f * vec2(0.8f * s.x - 0.6f * s.y, 0.6f * s.x + 0.8f * s.y);
        },
        [](vec2 s) { return vec2(0.5f) + vec2(0.2f * s.x + 0.25f * s.y, 0.4f * s.y); },
        [](vec2 s) { return vec2(0.5f) + vec2(-0.4f * s.x, 0.4f * s.y); }};
    for (const auto& map : maps) {
        MeshData mesh = square();
        for (vec2& st : mesh.texcoords) st = map(st * 1.4f - 0.7f);
        const PixmapModel model = make_model(one(mesh, given(40, 30)));
        ASSERT_EQ(model.facets.size(), 1u);
        EXPECT_NEAR(area(model), 4, 1e-5);
        for (std::size_t k = 0; k < 4; ++k) {
            const dvec2 uv = model.facets[0].texel_of(dvec3(mesh.positions[k]));
            EXPECT_NEAR(uv.x, double(mesh.texcoords[k].x) * 40, 1e-4);
            EXPECT_NEAR(uv.y, double(mesh.texcoords[k].y) * 30, 1e-4);
        }
    }
}

// ST of a trapezoid that are no affine map: a facet for each triangle.
TEST(Figures, STThatAreNotAffineArePerTriangle) {
    MeshData mesh = square();
    mesh.positions[2].x = 1;
    const PixmapModel model = make_model(one(mesh, given(16, 16)));
    EXPECT_EQ(model.facets.size(), 2u);
    EXPECT_NEAR(area(model), 3, 1e-6);
}

TEST(Figures, SeveralFiguresShareAPixmap) {
    MeshData left = square(), right = square();
    for (vec2& st : left.texcoords) st = st * vec2(0.5f, 1);
    for (vec2& st : right.texcoords) st = st * vec2(0.5f, 1) + vec2(0.5f, 0);
    scene::Scene scene = one(left, given(8, 4, "both"));
    scene.objects.push_back(
        {.name = "other", .mesh = make_mesh(right), .pixmap = given(8, 4, "both")});
    const PixmapModel model = make_model(scene);
    EXPECT_EQ(model.pixmaps.size(), 1u);
    EXPECT_EQ(model.figures.size(), 2u);
    EXPECT_NEAR(area(model), 8, 1e-6);
    scene.objects[1].pixmap.width = 9;
    EXPECT_THROW(make_model(scene), Error);
}

// Form factors are those of the figures alone; only a solver needs light.
TEST(Figures, NeedNoLight) {
    scene::Scene dark = one(square());
    dark.materials[0].Ke = vec3(0);
    const PixmapModel model = make_model(dark);
    EXPECT_EQ(model.figures.size(), 1u);
    EXPECT_THROW(check_emission(model), Error);
    EXPECT_NO_THROW(check_emission(make_model(one(square()))));
}

TEST(Figures, AnObjectWithoutAreaIsLeftOutWithAWarning) {
    EXPECT_EQ(left_out(make_model(one(square()))), std::vector<std::string>());
    for (const scene::PixmapChoice& pixmap : {scene::PixmapChoice{}, given(4, 4)}) {
        scene::Scene scene = one(square());
        scene.materials.push_back({.name = "dark"});
        MeshData line{.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                      .texcoords = {{0, 0}, {1, 0}, {1, 1}}};
        for (const char* name : {"line", "seam"})
            scene.objects.push_back(
                {.name = name, .mesh = make_mesh(line), .material = 1, .pixmap = pixmap});
        const PixmapModel model = make_model(scene);
        EXPECT_EQ(model.figures.size(), 1u);
        EXPECT_EQ(model.pixmaps.size(), 1u);
        EXPECT_EQ(left_out(model),
                  std::vector<std::string>{
                      "object 'line' has no area, so radiosity leaves it out, and 1 more like it"});
    }
}

/// The message of the Error that a scene gives.
std::string refusal(const scene::Scene& scene) {
    try {
        make_model(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Figures, WhatIsWrongIsSaid) {
    const auto says = [](const scene::Scene& scene, const std::string& part) {
        EXPECT_NE(refusal(scene).find(part), std::string::npos)
            << refusal(scene) << "\nexpected: " << part;
    };
    MeshData bad = square();
    bad.texcoords[2] = {1.5f, 1};
    says(one(bad, given(4, 4)), "outside its pixmap");
    bad.texcoords = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    says(one(bad, given(4, 4)), "ST have none");
    bad.texcoords.clear();
    says(one(bad, given(4, 4)), "no texture coordinates");
    says(one({.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}), "has no area and is to emit");
    says(one(square(), {}, 1.25f), "reflects 1.25");
    MeshData twice = square();  // two quads, one place in the pixmap
    for (int k = 0; k < 4; ++k) {
        twice.positions.push_back(twice.positions[std::size_t(k)] + vec3(0, 1, 0));
        twice.texcoords.push_back(twice.texcoords[std::size_t(k)]);
    }
    says(one(twice, given(4, 4)), "2.000 times");
    scene::Scene huge = one(square());
    huge.texels_per_unit = 1e6;
    says(huge, "expected at most 4096");
}

}  // namespace
}  // namespace gw::radiosity
