// Reads [camera], [fog], [[light]] and [material.NAME].
#include "scene/toml/toml_sections.h"

#include "scene/scene_builder.h"
#include "scene/text/text_file.h"
#include "scene/toml/luminous/toml_luminous.h"

namespace gw::scene {
namespace {

AreaLight to_area(const TomlValue& table) {
    using Shape = AreaLight::Shape;
    AreaLight area;
    std::vector<Key> keys{
        key("shape", area.shape,
            {{"disc", Shape::Disc}, {"rectangle", Shape::Rectangle}, {"line", Shape::Line}})};
    visit_area(area, KeyList{keys});
    read_table(table, keys);
    if (area.shape == Shape::None)
        table.fail(table.name + " has no shape; expected 'disc', 'rectangle' or 'line'");
    obey(table, fault_of(area));
    return area;
}

void read_attenuation(const TomlValue& value, Light& light) {
    expect_numbers(value, 3);
    light.constant_attenuation = to_float(value.elements[0], not_negative);
    light.linear_attenuation = to_float(value.elements[1], not_negative);
    light.quadratic_attenuation = to_float(value.elements[2], not_negative);
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
    if (light.kind != LightKind::Point && !table.find("direction"))
        table.fail("light has no direction; expected one that is not 0");
    obey(table, fault_of(light));
}

void warn_without_effect(const TomlValue& table, std::initializer_list<const char*> keys,
                         const std::string& where, Warnings& warnings) {
    for (const char* key : keys)
        if (const TomlValue* value = table.find(key)) {
            const std::string name = table.name + "." + key;
            warnings.add(*value->file, value->line, name, name + " has no effect " + where);
        }
}

void warn_of_kind(const TomlValue& table, const Light& light, Warnings& warnings) {
    if (light.kind == LightKind::Point)
        warn_without_effect(table, {"direction", "cone", "exponent"},
                            "on a point light; expected position and direction, of a spot",
                            warnings);
    if (light.kind == LightKind::Directional)
        warn_without_effect(table, {"position", "cone", "exponent", "attenuation"},
                            "on a directional light; expected a point light or a spot", warnings);
}

void read_scale(const TomlValue& value, vec2& scale) {
    scale = value.is_number() ? vec2(to_float(value)) : to_vec2(value);
}

// {scene = true, size = 256}: generated from the scene [K3.1].
Map to_scene_map(const TomlValue& value) {
    Map map{.origin = {*value.file, value.line},
            .wrap_s = Wrap::Clamp,
            .wrap_t = Wrap::Clamp,
            .from_scene = 128};
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
    map.wrap_s = map.wrap_t = clamp ? Wrap::Clamp : Wrap::Repeat;
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
    std::vector<Key> keys;
    visit_camera(camera, KeyList{keys});
    read_table(table, keys);
    obey(table, fault_of(camera));
    return camera;
}

Fog to_fog(const TomlValue& table, Warnings& warnings) {
    Fog fog;
    std::vector<Key> keys{
        key("mode", fog.mode,
            {{"linear", FogMode::Linear}, {"exp", FogMode::Exp}, {"exp2", FogMode::Exp2}})};
    visit_fog(fog, KeyList{keys});
    read_table(table, keys);
    obey(table, fault_of(fog));
    if (fog.mode == FogMode::Linear)
        warn_without_effect(table, {"density"}, "in mode linear; expected mode exp or exp2",
                            warnings);
    else
        warn_without_effect(table, {"start", "end"}, "in this mode; expected mode linear",
                            warnings);
    return fog;
}

Light to_light(const TomlValue& table, const LightScene& scene) {
    Light light;
    LuminousKeys luminous;
    if (!table.find("kind")) light.kind = kind_of(table);
    std::vector<Key> keys{
        key("name", light.name),
        key("kind", light.kind,
            {{"directional", LightKind::Directional},
             {"point", LightKind::Point},
             {"spot", LightKind::Spot}}),
        {"Is", [&](const TomlValue& value) { light.Is = to_color(value); }},
        {"attenuation", [&](const TomlValue& value) { read_attenuation(value, light); }},
        key("shadow", light.shadow,
            {{"none", Shadow::None}, {"volume", Shadow::Volume}, {"map", Shadow::Map}}),
        {"area", [&](const TomlValue& value) { light.area = to_area(value); }},
        {"only", [&](const TomlValue& value) { read_names(value, light.only); }},
    };
    visit_light(light, KeyList{keys});
    add_luminous_keys(keys, luminous);
    read_table(table, keys);
    check_kind(table, light);
    warn_of_kind(table, light, scene.warnings);
    read_luminous(table, luminous, scene, light);
    if (light.kind != LightKind::Directional && scene.origin != dvec3(0))
        light.position = vec3(to_dvec3(*table.find("position")) - scene.origin);
    return light;
}

void read_material(const TomlValue& table, Material& material) {
    float Tr = 0;
    std::vector<Key> keys{
        key("Tr", Tr, {0, 1}),
        map_key("map_Ka", material.map_Ka),
        map_key("map_Kd", material.map_Kd),
        map_key("map_Ks", material.map_Ks),
        map_key("map_Ke", material.map_Ke),
        map_key("refl", material.refl, MapKind::Sphere),
        map_key("refraction", material.refraction, MapKind::Sphere),
    };
    visit_material(material, KeyList{keys});
    read_table(table, keys);
    if (table.find("illum")) without_highlights(material);
    if (!table.find("Tr")) return;
    if (table.find("d")) table.find("Tr")->fail("Tr beside d; expected one of them (Tr = 1 - d)");
    material.d = 1 - Tr;
}

}  // namespace gw::scene
