// Small scenes for the tests of studies, without files.
#pragma once

#include "scene/scene.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"

#include <algorithm>

namespace gw::study {

inline MeshData shape(const char* name, const std::vector<double>& parameters) {
    const auto& all = scene::shapes();
    return std::find_if(all.begin(), all.end(),
                        [&](const scene::Shape& s) { return s.name == name; })
        ->make(parameters);
}

/// A ball of many triangles with a gloss, seen from the front under one light.
inline scene::Scene ball(int slices) {
    scene::Scene s;
    std::uint32_t id = 0;
    s.materials.push_back(
        {.name = "glossy", .Kd = vec3(0.7f, 0.4f, 0.9f), .Ks = vec3(0.3f), .Ns = 12});
    s.objects.push_back({.name = "ball",
                         .mesh = scene::make_numbered_mesh(
                             shape("sphere", {1, double(slices), slices / 2.0}), id)});
    s.lights.push_back({.name = "key", .direction = {-0.5f, -0.6f, -0.7f}, .Id = vec3(0.9f)});
    s.camera = scene::Camera{.eye = {0, 0, 5}, .fov = 28};
    return s;
}

/// A slanted card over a sheet of paper, under a round lamp: edges and a penumbra.
inline scene::Scene card() {
    scene::Scene s;
    std::uint32_t id = 0;
    s.materials.push_back({.name = "paper", .Kd = vec3(1)});
    s.objects.push_back(
        {.name = "sheet", .mesh = scene::make_numbered_mesh(shape("rectangle", {6, 6, 8, 8}), id)});
    s.objects.push_back(
        {.name = "card", .mesh = scene::make_numbered_mesh(shape("box", {1.3, 0.05, 0.9, 1}), id)});
    s.objects[1].world_from_object =
        dmat4(0.94, 0.1, 0.33, 0, -0.1, 0.99, 0, 0, -0.33, 0, 0.94, 0, -0.4, 1.2, 0, 1);
    s.lights.push_back({.name = "lamp",
                        .kind = scene::LightKind::Point,
                        .position = {-1, 5, 1},
                        .Id = vec3(0.8f),
                        .shadow = scene::Shadow::Volume,
                        .area = {scene::AreaLight::Shape::Disc, {0.8f, 0, 0}, {0, 0, 0.8f}, 16}});
    s.camera = scene::Camera{.eye = {0, 5, 4}, .at = {0, 0, 0}, .fov = 36};
    return s;
}

}  // namespace gw::study
