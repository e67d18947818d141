#include "scene/gltf/gltf_camera.h"

#include "gw/base/elementary.h"
#include "scene/draw/corners.h"
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

/// A right angle as exporters write it: in float it is more than in double.
constexpr double right_angle = pi / 2 + 1e-6;

/// The exponent that halves the light where glTF's square of a ramp between the cones halves it. Cones
/// without a ramp between them are even.
float exponent_of(double inner, double outer) {
    if (inner >= outer) return 0;
    const double middle = cos(outer) + std::sqrt(0.5) * (cos(inner) - cos(outer));
    return float(std::clamp(log(0.5) / log(middle), 0.0, 128.0));
}

void read_spot(const JsonValue& table, Light& light) {
    const auto spot = table.find("spot");
    const double outer =
        spot ? number_in(*spot, "outerConeAngle", pi / 4, {0.001, right_angle}) : pi / 4;
    const double inner = spot ? number_in(*spot, "innerConeAngle", 0, {0, right_angle}) : 0;
    if (inner > outer + 1e-6) spot->at("innerConeAngle").fail_expected("at most outerConeAngle");
    light.cone_angle = std::min(outer * degrees_per_radian, 90.0);
    light.spot_exponent = exponent_of(inner, outer);
}

LightKind kind_of(const JsonValue& type) {
    if (type.text() == "directional") return LightKind::Directional;
    if (type.text() == "point") return LightKind::Point;
    if (type.text() != "spot") type.fail_expected("directional, point or spot");
    return LightKind::Spot;
}

/// What arrives at p on a surface, either side of which may face the light.
double arriving(const GltfLight& of, const dvec3& p, const dvec3& normal) {
    const Light& light = of.light;
    const double most = double(std::max({light.Id.x, light.Id.y, light.Id.z}));
    if (light.kind == LightKind::Directional)
        return most * std::abs(dot3(normal, dvec3(light.direction)));
    const dvec3 d = p - of.position;
    const double square = std::max(dot3(d, d), 1e-12), distance = std::sqrt(square);
    const double facing = std::abs(dot3(normal, d)) / distance;
    if (light.kind == LightKind::Point) return most * facing / square;
    const double axis = dot3(dvec3(light.direction), d) / distance;
    if (axis < cos(light.cone_angle / degrees_per_radian)) return 0;
    return most * facing * pow(axis, double(light.spot_exponent)) / square;
}

/// A part of a surface and the light on it.
struct LitPart {
    double light, weight;
};

/// The light on a scene's surfaces, in the middles of parts of triangles.
class LitSurfaces {
public:
    LitSurfaces(const Scene& scene, const std::vector<GltfLight>& lights) : lights_(lights) {
        for_each_triangle(
            scene, [&](const WorldCorners&, const dvec3& twice) { area_ += length(twice) / 2; });
        for_each_triangle(scene,
                          [&](const WorldCorners& at, const dvec3& twice) { add(at, twice); });
    }

    /// The light beyond which a tenth of the surfaces lies. They count by their area and the root of
    /// their light: neither a bulb around its lamp nor a dark field decides. 0: none is lit.
    double bright() {
        std::sort(parts_.begin(), parts_.end(),
                  [](const LitPart& a, const LitPart& b) { return a.light > b.light; });
        double rest = 0;
        for (const LitPart& part : parts_) rest += part.weight / 10;
        for (const LitPart& part : parts_)
            if ((rest -= part.weight) <= 0) return part.light;
        return 0;
    }

private:
    static constexpr double parts_in_all = 4096;
    static constexpr int most_divisions = 16;

    static void for_each_triangle(const Scene& scene, const auto& visit) {
        for (const Object& object : scene.objects) {
            if (object.mesh->kind() != MeshKind::Triangles) continue;
            for (const Triangle& t : object.mesh->triangles()) {
                const WorldCorners at = world_corners(object, t);
                const dvec3 twice = cross3(at[1] - at[0], at[2] - at[0]);
                if (length(twice) > 0) visit(at, twice);
            }
        }
    }
    /// Divides a triangle into n n parts.
    void add(const WorldCorners& at, const dvec3& twice) {
        const double area = length(twice) / 2;
        const int n = int(std::clamp(std::ceil(std::sqrt(parts_in_all * area / area_)), 1.0,
                                     double(most_divisions)));
        const dvec3 normal = twice / (2 * area), u = (at[1] - at[0]) / double(n),
                    v = (at[2] - at[0]) / double(n);
        const auto add_part = [&](double i, double j) {
            double light = 0;
            for (const GltfLight& of : lights_)
                light += arriving(of, at[0] + u * i + v * j, normal);
            if (light > 0) parts_.push_back({light, std::sqrt(light) * area / (n * n)});
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                add_part(i + 1 / 3.0, j + 1 / 3.0);
                if (i + j + 1 < n) add_part(i + 2 / 3.0, j + 2 / 3.0);
            }
    }

    const std::vector<GltfLight>& lights_;
    double area_ = 0;
    std::vector<LitPart> parts_;
};

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
                      const Scene& scene) {
    const double bright = LitSurfaces(scene, lights).bright();
    const double divisor = std::max(bright, 1.0);
    if (divisor > 1)
        document.warn("exposure", "its lights give " + number_text(std::round(bright * 100) / 100) +
                                      " times white on bright surfaces; expected at most 1, so all "
                                      "are divided by it");
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
