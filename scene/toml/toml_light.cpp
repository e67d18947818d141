// [[light]]
#include "scene/toml/toml_sections.h"

namespace gw::scene {
namespace {

AreaLight to_area(const TomlValue& table) {
    using Shape = AreaLight::Shape;
    AreaLight area;
    read_table(
        table,
        {
            key("shape", area.shape,
                {{"disc", Shape::Disc}, {"rectangle", Shape::Rectangle}, {"line", Shape::Line}}),
            key("u", area.u),
            key("v", area.v),
            key("samples", area.samples, {1, 4096}),
        });
    if (area.shape == Shape::None)
        table.fail(table.name + " has no shape; expected 'disc', 'rectangle' or 'line'");
    if (area.u == vec3(0))
        table.fail(table.name + ".u is missing or 0; expected a half axis in world units");
    if (area.shape != Shape::Line && area.v == vec3(0))
        table.fail(table.name + ".v is missing or 0; expected a half axis in world units");
    return area;
}

void read_attenuation(const TomlValue& value, Light& light) {
    expect_numbers(value, 3);
    light.constant_attenuation = to_float(value.elements[0], not_negative);
    light.linear_attenuation = to_float(value.elements[1], not_negative);
    light.quadratic_attenuation = to_float(value.elements[2], not_negative);
    if (light.constant_attenuation + light.linear_attenuation + light.quadratic_attenuation == 0)
        value.fail(value.name + " is 0 everywhere; expected a factor above 0");
}

Key place_key(std::string name, vec3& field) {
    return {std::move(name), [&field](const TomlValue& value) {
                field = to_vec3(value);
                to_placeable(value);
            }};
}

void read_names(const TomlValue& value, std::set<std::string>& names) {
    for (std::string& name : to_strings(value)) names.insert(std::move(name));
}

// A position makes a point light, a direction a directional one, both a spot.
LightKind kind_of(const TomlValue& table) {
    const bool position = table.find("position"), direction = table.find("direction");
    if (!position && !direction)
        table.fail("light has neither position nor direction; expected one of them, or both");
    return position && direction ? LightKind::Spot
           : position            ? LightKind::Point
                                 : LightKind::Directional;
}

void check_kind(const TomlValue& table, const Light& light) {
    if (light.kind != LightKind::Directional && !table.find("position"))
        table.fail("light has no position; expected one");
    if (light.kind != LightKind::Point && (!table.find("direction") || light.direction == vec3(0)))
        table.fail("light has no direction; expected one that is not 0");
}

}  // namespace

Light to_light(const TomlValue& table) {
    Light light;
    if (!table.find("kind")) light.kind = kind_of(table);
    read_table(table,
               {
                   key("name", light.name),
                   key("kind", light.kind,
                       {{"directional", LightKind::Directional},
                        {"point", LightKind::Point},
                        {"spot", LightKind::Spot}}),
                   place_key("position", light.position),
                   place_key("direction", light.direction),
                   color_key("Ia", light.Ia),
                   color_key("Id", light.Id),
                   {"Is", [&](const TomlValue& value) { light.Is = to_color(value); }},
                   key("cone", light.cone_angle, {0, 90}),
                   key("exponent", light.spot_exponent, {0, 128}),
                   {"attenuation", [&](const TomlValue& value) { read_attenuation(value, light); }},
                   key("shadow", light.shadow,
                       {{"none", Shadow::None}, {"volume", Shadow::Volume}, {"map", Shadow::Map}}),
                   {"area", [&](const TomlValue& value) { light.area = to_area(value); }},
                   {"only", [&](const TomlValue& value) { read_names(value, light.only); }},
               });
    check_kind(table, light);
    return light;
}

}  // namespace gw::scene
