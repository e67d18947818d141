// [material.NAME], and the inline material of an object: MTL's words.
#include "scene/text/text_file.h"
#include "scene/toml/toml_sections.h"

namespace gw::scene {
namespace {

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
    if (!table.find("Tr")) return;
    if (table.find("d")) table.find("Tr")->fail("Tr beside d; expected one of them (Tr = 1 - d)");
    material.d = 1 - Tr;
}

}  // namespace gw::scene
