// Reads [camera], [fog], [[light]] and [material.NAME].
#include "scene/toml/toml_sections.h"

#include "scene/scene_builder.h"
#include "scene/text/text_file.h"

namespace gw::scene {
namespace {

Key place_key(std::string name, dvec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_placeable(value); }};
}

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

void read_scale(const TomlValue& value, vec2& scale) {
    scale = value.is_number() ? vec2(to_float(value)) : to_vec2(value);
}

// {scene = true, size = 256}: generated from the scene [K3.1].
Map to_scene_map(const TomlValue& value) {
    Map map{.origin = {*value.file, value.line}, .wrap = Wrap::Clamp, .from_scene = 128};
    bool scene = true;
    read_table(value, {key("scene", scene), key("size", map.from_scene, {8, 1024})});
    if (!scene) value.fail(value.name + ".scene is false; expected true, or file instead");
    return map;
}

// "wood.png" or {file = "wood.png", clamp = true, scale = [2, 2], offset = [0, 0]}
Map to_file_map(const TomlValue& value) {
    Map map;
    std::string file = value.text;
    bool clamp = false;
    if (value.kind == TomlKind::Table)
        read_table(value,
                   {
                       key("file", file),
                       key("clamp", clamp),
                       {"scale", [&](const TomlValue& scale) { read_scale(scale, map.scale); }},
                       key("offset", map.offset),
                   });
    else if (value.kind != TomlKind::String)
        value.fail_expected("a file name, a table with one, or an array of these");
    if (file.empty()) value.fail(value.name + " names no file; expected a texture's file name");
    map.file = find_file(std::filesystem::path(*value.file).parent_path(), file);
    map.wrap = clamp ? Wrap::Clamp : Wrap::Repeat;
    map.origin = {*value.file, value.line};
    return map;
}

// A surface map is looked up by texture coordinates; a sphere map by a ray, and it can be
// generated.
enum class MapKind { Surface, Sphere };

Map to_map(const TomlValue& value, MapKind kind) {
    const bool from_scene = kind == MapKind::Sphere && value.find("scene");
    return from_scene ? to_scene_map(value) : to_file_map(value);
}

std::vector<Map> to_maps(const TomlValue& value, MapKind kind) {
    if (value.kind != TomlKind::Array) return {to_map(value, kind)};
    std::vector<Map> maps;
    for (const TomlValue& element : value.elements) maps.push_back(to_map(element, kind));
    return maps;
}

Key map_key(std::string name, std::vector<Map>& field, MapKind kind = MapKind::Surface) {
    return {std::move(name),
            [&field, kind](const TomlValue& value) { field = to_maps(value, kind); }};
}

}  // namespace

Camera to_camera(const TomlValue& table) {
    Camera camera;
    read_table(table, {
                          place_key("eye", camera.eye),
                          place_key("at", camera.at),
                          place_key("up", camera.up),
                          key("fov", camera.fov, {0.1, 179}),
                          key("near", camera.near_plane, not_negative),
                          key("far", camera.far_plane, not_negative),
                          key("ortho", camera.ortho_height, not_negative),
                          key("aperture", camera.aperture, not_negative),
                          key("focus", camera.focus, not_negative),
                      });
    const dvec3 view = camera.at - camera.eye, side = glm::cross(view, camera.up);
    if (view == dvec3(0)) table.fail("camera.at is camera.eye; expected another point");
    if (side == dvec3(0)) table.fail("camera.up is along the view; expected another direction");
    if (camera.aperture > 0 && camera.ortho_height > 0)
        table.fail("camera.aperture beside ortho; expected a perspective camera");
    if (camera.far_plane > 0 && camera.far_plane <= camera.near_plane)
        table.fail("camera.far is not beyond camera.near; expected near < far");
    return camera;
}

Fog to_fog(const TomlValue& table) {
    Fog fog;
    read_table(
        table,
        {
            key("mode", fog.mode,
                {{"linear", FogMode::Linear}, {"exp", FogMode::Exp}, {"exp2", FogMode::Exp2}}),
            color_key("color", fog.color),
            key("density", fog.density, not_negative),
            key("start", fog.start, not_negative),
            key("end", fog.end, not_negative),
        });
    if (fog.mode == FogMode::Linear && fog.start >= fog.end)
        table.fail("fog.end is not beyond fog.start; expected start < end");
    return fog;
}

Light to_light(const TomlValue& table, const dvec3& origin) {
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
    if (light.kind != LightKind::Directional && origin != dvec3(0))
        light.position = vec3(to_dvec3(*table.find("position")) - origin);
    return light;
}

void read_material(const TomlValue& table, Material& material) {
    float Tr = 0;
    read_table(table, {
                          color_key("Ka", material.Ka),
                          color_key("Kd", material.Kd),
                          color_key("Ks", material.Ks),
                          color_key("Ke", material.Ke),
                          key("Ns", material.Ns, {0, 10000}),
                          key("Ni", material.Ni, {0.01, 100}),
                          key("d", material.d, {0, 1}),
                          key("Tr", Tr, {0, 1}),
                          color_key("Tf", material.Tf),
                          key("illum", material.illum, {0, 10}),
                          map_key("map_Ka", material.map_Ka),
                          map_key("map_Kd", material.map_Kd),
                          map_key("map_Ks", material.map_Ks),
                          map_key("map_Ke", material.map_Ke),
                          map_key("refl", material.refl, MapKind::Sphere),
                          map_key("refraction", material.refraction, MapKind::Sphere),
                      });
    if (table.find("illum")) without_highlights(material);
    if (!table.find("Tr")) return;
    if (table.find("d")) table.find("Tr")->fail("Tr beside d; expected one of them (Tr = 1 - d)");
    material.d = 1 - Tr;
}

}  // namespace gw::scene
