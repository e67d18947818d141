// Small scenes for the tests of passes.
#pragma once

#include "scene/scene.h"

#include <array>

namespace gw::multipass {

/// A square of side 2 in the plane z = 0, two triangles, facing +z.
inline MeshRef square_mesh() {
    return make_mesh({.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                      .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                      .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                      .indices = {0, 1, 2, 0, 2, 3}});
}

/// A 1x1 map of one colour, 8 bits a channel.
inline scene::Map plain_map(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    const std::array<std::uint8_t, 4> texel{r, g, b, 255};
    return {.file = "plain", .texture = make_texture8("plain", 1, 1, texel)};
}

/// A named square with a material of its own, shifted in the world.
inline void add_square(scene::Scene& scene, const char* name, const scene::Material& material,
                       const dvec3& at = dvec3(0)) {
    scene::Object square{.name = name, .mesh = square_mesh(), .material = scene.materials.size()};
    square.world_from_object[3] = dvec4(at, 1);
    scene.materials.push_back(material);
    scene.objects.push_back(std::move(square));
}

/// Squares "left" and "right", lit by the directional lights "key" and "fill"; orthographic, 4
/// units high.
inline scene::Scene two_squares() {
    scene::Scene s;
    scene::Material matte{.name = "matte", .Ka = vec3(0.25f), .Kd = vec3(0.5f)};
    scene::Material glossy{
        .name = "glossy", .Ka = vec3(0.125f), .Kd = vec3(0.25f), .Ks = vec3(0.25f), .Ns = 4};
    add_square(s, "left", matte, {-1.25, 0, 0});
    add_square(s, "right", glossy, {1.25, 0, 0});
    s.lights.push_back(
        {.name = "key", .direction = {0, 0, -1}, .Ia = vec3(0.25f), .Id = vec3(0.5f)});
    s.lights.push_back(
        {.name = "fill", .direction = {-0.6f, 0, -0.8f}, .Ia = vec3(0.125f), .Id = vec3(0.25f)});
    s.camera = scene::Camera{.eye = {0, 0, 5}, .near_plane = 1, .far_plane = 9, .ortho_height = 4};
    return s;
}

}  // namespace gw::multipass
