// Bodies over a floor in one light, whose shadows are compared with the truth.
#pragma once

#include "multipass/frame/driver.h"
#include "scene/toml/shape_table.h"
#include "tests/multipass/scenes.h"
#include "tests/multipass/truth.h"

#include <gtest/gtest.h>

namespace gw::multipass {

inline constexpr int window_width = 96, window_height = 72;

inline MeshRef mesh_of(std::vector<vec3> positions, std::vector<std::uint32_t> indices) {
    return make_mesh({.positions = std::move(positions), .indices = std::move(indices)});
}

inline MeshRef floor_mesh() {
    return mesh_of({{-6, 0, -6}, {6, 0, -6}, {6, 0, 6}, {-6, 0, 6}}, {0, 2, 1, 0, 3, 2});
}

/// A box about the origin, closed, counter-clockwise from outside.
inline MeshRef box_mesh(float h = 0.5f) {
    return mesh_of({{-h, -h, -h},
                    {h, -h, -h},
                    {h, h, -h},
                    {-h, h, -h},
                    {-h, -h, h},
                    {h, -h, h},
                    {h, h, h},
                    {-h, h, h}},
                   {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                    3, 6, 2, 3, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3});
}

/// Without its lid: open.
inline MeshRef open_box_mesh() {
    MeshData data = box_mesh()->data();
    data.indices.resize(30);
    return make_mesh(data);
}

/// Three wings at one edge: not a manifold.
inline MeshRef wings_mesh() {
    return mesh_of(
        {{-1, 0, 0}, {1, 0, 0}, {0, 0.2f, 1.5f}, {0.3f, 0.7f, -1.5f}, {0.2f, -0.7f, 1.3f}},
        {0, 1, 2, 0, 1, 3, 1, 0, 4});
}

struct Case {
    scene::Scene s;
    explicit Case(MeshRef caster = box_mesh(), const dvec3& at = {0, 1.2, 0}) {
        s.materials.push_back({.Ka = vec3(0), .Kd = vec3(1)});
        s.objects.push_back({.name = "floor", .mesh = floor_mesh()});
        s.objects.push_back({.name = "caster", .mesh = std::move(caster)});
        s.objects.back().world_from_object[3] = dvec4(at, 1);
        s.lights.push_back(
            {.name = "sun", .direction = {-0.5f, -1, -0.25f}, .shadow = scene::Shadow::Volume});
        s.camera = scene::Camera{.eye = {1, 5, 6}, .at = {0, 0.3, 0}, .fov = 40};
    }
    Case& lamp(const vec3& position) {
        s.lights[0].kind = scene::LightKind::Point;
        s.lights[0].position = position;
        return *this;
    }
};

/// Compares the stencil plane with the truth. `least`: of dark pixels that were compared, so that
/// the test can fail.
inline void expect_true(const scene::Scene& s, const Profile& profile = vgx(),
                        std::size_t least = 50) {
    const scene::View view = scene::make_view(s, window_width, window_height);
    const auto machine = make_reference(profile, window_width, window_height);
    render(*machine, s, view, {.one_winner = OneWinner::Never});
    const auto truth = true_shadows(s, view);
    std::size_t dark = 0, wrong = 0;
    for (int y = 0; y < window_height; ++y)
        for (int x = 0; x < window_width; ++x) {
            const Truth expected = truth_at(truth, window_width, window_height, x, y);
            if (expected == Truth::Edge || expected == Truth::Background) continue;
            dark += expected == Truth::Dark;
            wrong += (machine->planes().stencil[std::size_t(y * window_width + x)] != 0) !=
                     (expected == Truth::Dark);
        }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GE(dark, least);
}

/// A scene shape with some of its parameters changed.
inline MeshRef shape(const std::string& name,
                     std::initializer_list<std::pair<std::string, double>> changes) {
    for (const scene::Shape& candidate : scene::shapes()) {
        if (candidate.name != name) continue;
        std::vector<double> values;
        for (const scene::ShapeParameter& p : candidate.parameters) {
            values.push_back(p.value);
            for (const auto& [key, value] : changes)
                if (key == p.name) values.back() = value;
        }
        return make_mesh(candidate.make(values));
    }
    return nullptr;
}

}  // namespace gw::multipass
