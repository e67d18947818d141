#include "scene/validate/check.h"

#include "gw/error.h"
#include "scene/text/suggest.h"
#include "scene/validate/rules.h"

#include <charconv>
#include <string>
#include <type_traits>

namespace gw::scene {
namespace {

/// The shortest text of the number's own type.
template <class Number>
std::string text_of(Number value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

/// A part of a scene, as messages begin: "light 'sun'".
class CheckedPart {
public:
    explicit CheckedPart(std::string name, std::string inner = "")
        : name_(std::move(name)), inner_(std::move(inner)) {}

    [[noreturn]] void fail(const std::string& key, const std::string& is,
                           const std::string& expected) const {
        throw Error(name_ + ", " + inner_ + key + ": " + is + "; expected " + expected);
    }
    void obey(const std::optional<Fault>& fault) const {
        if (fault) fail(fault->field.member, fault->is, fault->expected);
    }
    template <class Number>
    void number(FieldName name, Number value, Range range) const {
        if (!range.contains(value))
            fail(name.member, text_of(value),
                 range_text(std::is_integral_v<Number> ? "a whole number" : "a number", range));
    }
    template <class Vector>
    void place(FieldName name, const Vector& v) const {
        for (int i = 0; i < Vector::length(); ++i) number(name, v[i], placeable);
    }
    void color(FieldName name, const vec3& v) const {
        for (int i = 0; i < 3; ++i) number(name, v[i], not_negative);
    }

private:
    std::string name_, inner_;
};

std::string named(const char* kind, const std::string& name) {
    return std::string(kind) + " '" + printable(name) + "'";
}

void check(const Light& light) {
    const std::string name = named("light", light.name);
    const CheckedPart part(name), area(name, "area.");
    visit_light(light, part);
    if (light.Is) part.color("Is", *light.Is);
    part.number("constant_attenuation", light.constant_attenuation, not_negative);
    part.number("linear_attenuation", light.linear_attenuation, not_negative);
    part.number("quadratic_attenuation", light.quadratic_attenuation, not_negative);
    part.obey(fault_of(light));
    visit_area(light.area, area);
    area.obey(fault_of(light.area));
}

void check(const Material& material) {
    const CheckedPart part(named("material", material.name));
    visit_material(material, part);
    for (const auto* maps : {&material.map_Ka, &material.map_Kd, &material.map_Ks, &material.map_Ke,
                             &material.refl, &material.refraction})
        for (const Map& map : *maps)
            if (!map.texture && map.from_scene == 0) part.fail("map", "None", "a texture");
}

void check(const PixmapChoice& pixmap, const CheckedPart& part) {
    if (pixmap.width != 0) part.number("width", pixmap.width, pixmap_sides);
    if (pixmap.height != 0) part.number("height", pixmap.height, pixmap_sides);
    if (pixmap.texels_per_unit != 0)
        part.number("texels_per_unit", pixmap.texels_per_unit, texels_per_unit);
    if (pixmap.emission) part.color("emission", *pixmap.emission);
    part.obey(fault_of(pixmap));
}

void check(const Object& object, std::size_t materials) {
    const std::string name = named("object", object.name);
    const CheckedPart part(name);
    if (!object.mesh) part.fail("mesh", "None", "one");
    if (object.material >= materials)
        part.fail("material", std::to_string(object.material),
                  materials == 0
                      ? "a scene with materials"
                      : "an index into materials, 0 .. " + std::to_string(materials - 1));
    for (int column = 0; column < 4; ++column)
        part.place("world_from_object", object.world_from_object[column]);
    part.obey(fault_of(object.world_from_object));
    part.place("move", object.move);
    check(object.pixmap, CheckedPart(name, "pixmap."));
    if (object.glare) visit_glare(*object.glare, CheckedPart(name, "glare."));
}

}  // namespace

void check_scene(const Scene& scene) {
    for (const Material& material : scene.materials) check(material);
    for (const Object& object : scene.objects) check(object, scene.materials.size());
    for (const Light& light : scene.lights) check(light);
    if (scene.camera) visit_camera(*scene.camera, CheckedPart("camera"));
    if (scene.camera) CheckedPart("camera").obey(fault_of(*scene.camera));
    if (scene.fog) visit_fog(*scene.fog, CheckedPart("fog"));
    if (scene.fog) CheckedPart("fog").obey(fault_of(*scene.fog));
    const CheckedPart part(named("scene", scene.name));
    part.color("background", scene.background);
    if (scene.texels_per_unit != 0)
        part.number("texels_per_unit", scene.texels_per_unit, texels_per_unit);
}

}  // namespace gw::scene
