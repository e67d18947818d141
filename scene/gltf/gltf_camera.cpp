#include "scene/gltf/gltf_camera.h"

#include "gw/base/elementary.h"
#include "scene/gltf/gltf_material.h"
#include "scene/text/number.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

constexpr double degrees_per_radian = 180 / pi;

/// A column of the node's matrix with length 1: a direction in the world.
dvec3 axis_of(const dmat4& world_from_node, int column) {
    const dvec3 v(world_from_node[column]);
    const double size = length(v);
    return size > 0 ? v / size : dvec3(column == 0, column == 1, column == 2);
}

double number_in(const JsonValue& table, const char* key, double standard, Range range) {
    const auto value = table.find(key);
    return value ? value->number(range) : standard;
}

/// The exponent that halves the light where glTF's square of a ramp between the cones halves it.
float exponent_of(double inner, double outer) {
    const double middle = cos(outer) + std::sqrt(0.5) * (cos(inner) - cos(outer));
    return float(std::clamp(log(0.5) / log(middle), 0.0, 128.0));
}

void read_spot(const JsonValue& table, Light& light) {
    const auto spot = table.find("spot");
    const double outer =
        spot ? number_in(*spot, "outerConeAngle", pi / 4, {0.001, pi / 2}) : pi / 4;
    const double inner = spot ? number_in(*spot, "innerConeAngle", 0, {0, pi / 2}) : 0;
    if (inner >= outer) spot->at("innerConeAngle").fail_expected("less than outerConeAngle");
    light.cone_angle = std::min(outer * degrees_per_radian, 90.0);
    light.spot_exponent = exponent_of(inner, outer);
}

LightKind kind_of(const JsonValue& type) {
    if (type.text() == "directional") return LightKind::Directional;
    if (type.text() == "point") return LightKind::Point;
    if (type.text() != "spot") type.fail_expected("directional, point or spot");
    return LightKind::Spot;
}

/// What arrives at a point that faces the light.
double at_point(const GltfLight& light, const dvec3& p) {
    const vec3& I = light.light.Id;
    const double most = double(std::max({I.x, I.y, I.z}));
    const dvec3 d = p - light.position;
    return light.light.kind == LightKind::Directional ? most : most / std::max(dot3(d, d), 1e-12);
}

}  // namespace

void place_camera(Camera& camera, const dmat4& world_from_node) {
    camera.eye = dvec3(world_from_node[3]);
    camera.at = camera.eye - axis_of(world_from_node, 2);
    camera.up = axis_of(world_from_node, 1);
}

vec3 light_direction(const dmat4& world_from_node) { return vec3(-axis_of(world_from_node, 2)); }

Camera read_gltf_camera(const JsonValue& table, const dmat4& world_from_node) {
    Camera camera;
    place_camera(camera, world_from_node);
    const JsonValue type = table.at("type");
    if (type.text() != "perspective" && type.text() != "orthographic")
        type.fail_expected("perspective or orthographic");
    const JsonValue lens = table.at(type.text());
    camera.near_plane = number_in(lens, "znear", 0, {0, 1e18});
    camera.far_plane = number_in(lens, "zfar", 0, {0, 1e18});
    if (camera.far_plane != 0 && camera.far_plane <= camera.near_plane)
        lens.at("zfar").fail_expected("more than znear");
    if (type.text() == "perspective")
        camera.fov = lens.at("yfov").number({0.1 / degrees_per_radian, 179 / degrees_per_radian}) *
                     degrees_per_radian;
    else
        camera.ortho_height = 2 * lens.at("ymag").number({1e-9, 1e18});
    return camera;
}

GltfLight read_gltf_light(const GltfDocument& document, const JsonValue& table,
                          const dmat4& world_from_node, const std::string& name) {
    GltfLight out;
    Light& light = out.light;
    light.name = name;
    light.kind = kind_of(table.at("type"));
    light.direction = light_direction(world_from_node);
    out.position = dvec3(world_from_node[3]);
    dvec3 color(1);
    if (const auto value = table.find("color"))
        for (int k = 0; k < 3; ++k) color[k] = (*value)[std::size_t(k)].number({0, 1e6});
    light.Id = vec3(color * (number_in(table, "intensity", 1, {0, 1e18}) / pi));
    if (light.kind == LightKind::Spot) read_spot(table, light);
    if (light.kind != LightKind::Directional) {
        light.constant_attenuation = 0;
        light.linear_attenuation = 1;
    }
    if (table.find("range"))
        document.warn("light range", "light '" + name + "': its range is left out");
    return out;
}

ExposedLights exposed(const GltfDocument& document, const std::vector<GltfLight>& lights,
                      const dvec3& center) {
    double sum = 0;
    for (const GltfLight& light : lights) sum += at_point(light, center);
    const double divisor = std::max(sum, 1.0);
    if (divisor > 1)
        document.warn("exposure",
                      "its lights give " + number_text(double(float(sum))) +
                          " times white in the middle of the scene; expected at most 1, "
                          "so all are divided by it");
    ExposedLights out{{}, lights.empty() ? 0 : pi * divisor};
    for (const GltfLight& light : lights) {
        out.lights.push_back(light.light);
        Light& shown = out.lights.back();
        if (shown.kind != LightKind::Directional && shown.Id != vec3(0))
            shown.luminous = Luminous{dvec3(shown.Id) * pi, nullptr, 0};
        shown.Id = encoded(dvec3(light.light.Id) / divisor);
    }
    return out;
}

}  // namespace gw::scene
