#include "python/binding/checked.h"

#include "gw/error.h"

#include <fmt/format.h>

#include <cmath>

namespace gw::python {
namespace {

/// The largest place, as in scene files; the largest colour, attenuation or distance.
constexpr double far_away = 1e18, any_size = 1e30;

/// Collects what is said before each fault: "light 'sun', ".
struct Part {
    std::string name;

    [[noreturn]] void fail(const char* key, const std::string& is, const char* expected) const {
        throw Error(fmt::format("{}, {}: {}; expected {}", name, key, is, expected));
    }
    void range(const char* key, double value, double low, double high) const {
        check_range(name + ", " + key, value, low, high);
    }
    template <class Vector>
    void place(const char* key, const Vector& v) const {
        for (int i = 0; i < Vector::length(); ++i) range(key, double(v[i]), -far_away, far_away);
    }
    void color(const char* key, const vec3& v) const {
        for (int i = 0; i < 3; ++i) range(key, double(v[i]), 0, any_size);
    }
    template <class Vector>
    void direction(const char* key, const Vector& v) const {
        place(key, v);
        if (v == Vector(0)) fail(key, "0", "a direction that is not 0");
    }
};

void check(const scene::Camera& camera) {
    const Part part{"camera"};
    part.place("eye", camera.eye);
    part.place("at", camera.at);
    part.direction("up", camera.up);
    part.range("fov", camera.fov, 0.1, 179);
    for (const auto& [key, value] : {std::pair{"near_plane", camera.near_plane},
                                     {"far_plane", camera.far_plane},
                                     {"ortho_height", camera.ortho_height},
                                     {"aperture", camera.aperture},
                                     {"focus", camera.focus}})
        part.range(key, value, 0, any_size);
    if (camera.eye == camera.at) part.fail("at", "the eye", "another point");
    if (cross(camera.at - camera.eye, camera.up) == dvec3(0))
        part.fail("up", "along the view", "another direction");
    if (camera.aperture > 0 && camera.ortho_height > 0)
        part.fail("aperture", "above 0 beside ortho_height", "a perspective camera");
    if (camera.far_plane > 0 && camera.far_plane <= camera.near_plane)
        part.fail("far_plane", "not beyond near_plane", "near < far");
}

void check(const scene::Fog& fog) {
    const Part part{"fog"};
    part.color("color", fog.color);
    part.range("density", double(fog.density), 0, any_size);
    part.range("start", double(fog.start), 0, any_size);
    part.range("end", double(fog.end), 0, any_size);
    if (fog.mode == FogMode::Linear && fog.start >= fog.end)
        part.fail("end", "not beyond start", "start < end");
}

void check(const scene::AreaLight& area, const Part& part) {
    using Shape = scene::AreaLight::Shape;
    part.range("area.samples", area.samples, 1, 4096);
    part.place("area.u", area.u);
    part.place("area.v", area.v);
    if (area.shape == Shape::None) return;
    if (area.u == vec3(0)) part.fail("area.u", "0", "a half axis in world units");
    if (area.shape != Shape::Line && area.v == vec3(0))
        part.fail("area.v", "0", "a half axis in world units");
}

void check(const scene::Light& light) {
    const Part part{"light '" + light.name + "'"};
    part.place("position", light.position);
    part.place("direction", light.direction);
    if (light.kind != scene::LightKind::Point) part.direction("direction", light.direction);
    part.color("Ia", light.Ia);
    part.color("Id", light.Id);
    if (light.Is) part.color("Is", *light.Is);
    part.range("cone_angle", light.cone_angle, 0, 90);
    part.range("spot_exponent", double(light.spot_exponent), 0, 128);
    double factor = 0;
    for (const auto& [key, value] : {std::pair{"constant_attenuation", light.constant_attenuation},
                                     {"linear_attenuation", light.linear_attenuation},
                                     {"quadratic_attenuation", light.quadratic_attenuation}}) {
        part.range(key, double(value), 0, any_size);
        factor += double(value);
    }
    if (factor == 0) part.fail("attenuation", "0 everywhere", "a factor above 0");
    check(light.area, part);
}

void check(const scene::Material& m) {
    const Part part{"material '" + m.name + "'"};
    part.color("Ka", m.Ka);
    part.color("Kd", m.Kd);
    part.color("Ks", m.Ks);
    part.color("Ke", m.Ke);
    part.color("Tf", m.Tf);
    part.range("Ns", double(m.Ns), 0, 10000);
    part.range("Ni", double(m.Ni), 0.01, 100);
    part.range("d", double(m.d), 0, 1);
    part.range("illum", m.illum, 0, 10);
    for (const auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
        for (const scene::Map& map : *maps)
            if (!map.texture && map.from_scene == 0) part.fail("map", "None", "a texture");
}

void check(const scene::PixmapChoice& pixmap, const Part& part) {
    part.range("pixmap.width", pixmap.width, 0, 4096);
    part.range("pixmap.height", pixmap.height, 0, 4096);
    part.range("pixmap.texels_per_unit", pixmap.texels_per_unit, 0, 1e9);
    if (pixmap.emission) part.color("pixmap.emission", *pixmap.emission);
    if ((pixmap.width == 0) != (pixmap.height == 0))
        part.fail("pixmap.height", "without a width, or the reverse", "both, or none");
    if (!pixmap.name.empty() && !pixmap.given_st)
        part.fail("pixmap.name", pixmap.name, "given_st = True beside a name");
    if (pixmap.width == 0 && pixmap.given_st)
        part.fail("pixmap.width", "0", "a size beside given_st");
    if (pixmap.width != 0 && pixmap.texels_per_unit != 0)
        part.fail("pixmap.texels_per_unit", "beside a size", "one of them");
}

void check(const scene::Object& object, std::size_t materials) {
    const Part part{"object '" + object.name + "'"};
    if (!object.mesh) part.fail("mesh", "None", "an object that Scene.add made");
    if (object.material >= materials)
        part.fail("material", std::to_string(object.material),
                  materials == 0
                      ? "a scene with materials"
                      : fmt::format("an index into materials, 0 .. {}", materials - 1).c_str());
    for (int column = 0; column < 4; ++column)
        part.place("world_from_object", object.world_from_object[column]);
    const dmat4& m = object.world_from_object;
    if (dvec4(m[0][3], m[1][3], m[2][3], m[3][3]) != dvec4(0, 0, 0, 1))
        part.fail("world_from_object", "a last row of other numbers", "0, 0, 0, 1 there");
    if (glm::determinant(dmat3(m)) == 0)
        part.fail("world_from_object", "a matrix without an inverse", "one that has an inverse");
    part.place("move", object.move);
    check(object.pixmap, part);
    if (!object.glare) return;
    part.range("glare.radius", object.glare->radius, 1e-9, 1e9);
    part.range("glare.strength", double(object.glare->strength), 0, any_size);
    part.range("glare.rays", object.glare->rays, 0, 64);
    part.range("glare.samples", object.glare->samples, 1, 4096);
}

}  // namespace

void check_range(const std::string& name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw Error(fmt::format("{}: {:.9g}; expected {:.9g} .. {:.9g}", name, value, low, high));
}

void check_scene(const scene::Scene& scene) {
    const Part part{"scene '" + scene.name + "'"};
    for (const scene::Material& material : scene.materials) check(material);
    for (const scene::Object& object : scene.objects) check(object, scene.materials.size());
    for (const scene::Light& light : scene.lights) check(light);
    if (scene.camera) check(*scene.camera);
    if (scene.fog) check(*scene.fog);
    part.color("background", scene.background);
    part.range("texels_per_unit", scene.texels_per_unit, 0, 1e9);
}

SceneInView::SceneInView(const scene::Scene& given, const std::optional<scene::Camera>& camera,
                         int width, int height)
    : scene(given) {
    check_window(width, height);
    if (camera) scene.camera = camera;
    check_scene(scene);
    scene::add_defaults(scene, width, height);
    view = scene::make_view(scene, width, height);
}

}  // namespace gw::python
