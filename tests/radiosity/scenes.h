// Small scenes whose form factors or radiosities are known.
#pragma once

#include "radiosity/model/figures.h"
#include "scene/scene.h"

#include <string>

namespace gw::radiosity {

/// A parallelogram from `corner` along a and b, facing cross(a, b), as one quad with ST at its
/// corners.
inline void add_quad(scene::Scene& scene, const std::string& name, const vec3& corner,
                     const vec3& a, const vec3& b, float rho = 0, float emission = 0) {
    scene.materials.push_back({.name = name, .Kd = vec3(rho), .Ke = vec3(emission)});
    scene.objects.push_back(
        {.name = name,
         .mesh = make_mesh({.primitive = Primitive::Quads,
                            .positions = {corner, corner + a, corner + a + b, corner + b},
                            .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}),
         .material = scene.materials.size() - 1});
}

/// A closed box of these sides whose walls face inwards.
inline scene::Scene closed_box(const vec3& s, float rho, float emission) {
    scene::Scene scene;
    const vec3 x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
    add_quad(scene, "floor", {0, 0, 0}, z, x, rho, emission);
    add_quad(scene, "ceiling", y, x, z, rho, emission);
    add_quad(scene, "left", {0, 0, 0}, y, z, rho, emission);
    add_quad(scene, "right", x, z, y, rho, emission);
    add_quad(scene, "back", {0, 0, 0}, x, y, rho, emission);
    add_quad(scene, "front", z, y, x, rho, emission);
    return scene;
}

/// The form factor to the texels of an object's figures.
template <class Row>
double to_object(const PixmapModel& model, const Row& row, const std::string& name) {
    double sum = 0;
    for (std::size_t i = 0; i < row.texels.size(); ++i)
        for (const Figure& figure : model.figures) {
            const Pixmap& pixmap = model.pixmaps[figure.pixmap];
            if (figure.name == name && row.texels[i] >= pixmap.first &&
                row.texels[i] < pixmap.first + pixmap.count())
                sum += row.factors[i];
        }
    return sum;
}

}  // namespace gw::radiosity
