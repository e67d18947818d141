#include "hiddensurface/faces/flat_colors.h"

#include "gw/base/arithmetic.h"
#include "hiddensurface/model/normal.h"
#include "scene/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {

namespace {

FlatColor to_flat(const dvec3& v) {
    const auto byte = [](double x) { return static_cast<std::uint16_t>(quantize(x, 8)); };
    return {byte(v.x), byte(v.y), byte(v.z)};
}

/// The first of Kd, Ke, Ka and Ks that is not black; grey if all are.
dvec3 first_color(const scene::Material& material) {
    for (const vec3& color : {material.Kd, material.Ke, material.Ka, material.Ks})
        if (color != vec3(0)) return dvec3(color);
    return dvec3(0.3);
}

/// Whether it stands for no material: without a name, or what a file without materials gets.
bool is_none(const scene::Material& material) {
    const scene::Material& none = scene::default_material();
    return material.name.empty() || (material.name == none.name && material.Kd == none.Kd &&
                                     material.Ka == none.Ka && material.Ks == none.Ks);
}

/// One of many hues: neighbouring numbers are far apart on the circle.
dvec3 own_color(std::uint32_t id) {
    const double hue = 6 * std::fmod(0.618033988749895 * id, 1.0);
    const auto channel = [hue](double middle) {
        const double away = std::abs(std::remainder(hue - middle, 6.0));
        return 0.25 + 0.7 * std::clamp(2 - away, 0.0, 1.0);
    };
    return {channel(0), channel(2), channel(4)};
}

/// |cos| of the angle between the normal and the line of sight.
double facing(const Polygon& polygon, const dvec3& eye) {
    const dvec3 n = polygon_normal(polygon.world), to_eye = eye - polygon.world[0];
    const double size = std::sqrt(dot3(n, n) * dot3(to_eye, to_eye));
    return size > 0 ? std::abs(dot3(n, to_eye)) / size : 0;
}

}  // namespace

std::map<std::uint32_t, FlatColor> flat_colors(const Input& input) {
    std::map<std::uint32_t, FlatColor> colors;
    colors[0] = to_flat(dvec3(input.scene.background));
    for (const Polygon& polygon : input.polygons) {
        const scene::Material& material =
            input.scene.materials.at(input.scene.objects[polygon.object].material);
        const dvec3 color = is_none(material) ? own_color(polygon.id) : first_color(material);
        colors[polygon.id] = to_flat(color * (0.4 + 0.6 * facing(polygon, input.view.camera.eye)));
    }
    return colors;
}

std::string hex_of(const FlatColor& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

std::map<std::uint32_t, std::string> hex_colors(const Input& input) {
    std::map<std::uint32_t, std::string> colors;
    for (const auto& [id, color] : flat_colors(input)) colors[id] = hex_of(color);
    return colors;
}

}  // namespace gw::hiddensurface
