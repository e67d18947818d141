// [material.NAME], and the inline material of an object: MTL's words.
#include "scene/text_file.h"
#include "scene/toml_sections.h"

namespace gw::scene {

namespace {

void read_scale(const TomlValue& value, vec2& scale) {
    scale = value.is_number() ? vec2(to_float(value)) : to_vec2(value);
}

// "wood.png" or {file = "wood.png", clamp = true, scale = [2, 2], offset = [0, 0]}
Map to_map(const TomlValue& value) {
    Map map;
    std::string file = value.text;
    bool clamp = false;
    if (value.kind == TomlKind::Table)
        read_table(value, {
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

std::vector<Map> to_maps(const TomlValue& value) {
    if (value.kind != TomlKind::Array) return {to_map(value)};
    std::vector<Map> maps;
    for (const TomlValue& element : value.elements) maps.push_back(to_map(element));
    return maps;
}

Key map_key(std::string name, std::vector<Map>& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_maps(value); }};
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
                          map_key("refl", material.refl),
                          map_key("refraction", material.refraction),
                      });
    if (!table.find("Tr")) return;
    if (table.find("d")) table.find("Tr")->fail("Tr beside d; expected one of them (Tr = 1 - d)");
    material.d = 1 - Tr;
}

}  // namespace gw::scene
