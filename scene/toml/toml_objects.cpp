#include "scene/toml/toml_objects.h"

#include "scene/geometry/divide.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <algorithm>

namespace gw::scene {

/// The keys of one table.
struct TomlObjects::ObjectTable {
    const TomlValue& table;
    std::string name, file;
    const TomlValue *material = nullptr, *crease = nullptr, *parts = nullptr;
    TomlShape shape;
    int divide = 1;
    bool visible = true;
    Object placed;  ///< without name, mesh and material
};

namespace {

std::vector<std::string> names_of(const auto& named) {
    std::vector<std::string> names;
    for (const auto& n : named) names.push_back(n.name);
    return names;
}

Glare to_glare(const TomlValue& table) {
    Glare glare;
    read_table(table, {
                          key("radius", glare.radius, {1e-9, 1e9}),
                          key("strength", glare.strength, not_negative),
                          key("rays", glare.rays, {0, 64}),
                          key("samples", glare.samples, {1, 4096}),
                      });
    return glare;
}

// Sides of 1 to 4096 texels.
void read_sides(const TomlValue& value, PixmapChoice& pixmap) {
    expect_numbers(value, 2);
    pixmap.width = to_int(value.elements[0], {1, 4096});
    pixmap.height = to_int(value.elements[1], {1, 4096});
}

PixmapChoice to_pixmap(const TomlValue& table) {
    PixmapChoice pixmap;
    pixmap.origin = {*table.file, table.line};
    vec3 emission(0);
    read_table(table, {
                          key("name", pixmap.name),
                          {"size", [&](const TomlValue& value) { read_sides(value, pixmap); }},
                          key("texels", pixmap.texels_per_unit, {1e-9, 1e9}),
                          key("st", pixmap.given_st, {{"automatic", false}, {"texcoords", true}}),
                          color_key("emission", emission),
                      });
    if (table.find("emission")) pixmap.emission = emission;
    if (!pixmap.name.empty() && !pixmap.given_st)
        table.fail("pixmap '" + printable(pixmap.name) +
                   "' has automatic ST; expected st = \"texcoords\" where a pixmap has a name");
    if (pixmap.width == 0 && pixmap.given_st)
        table.fail("pixmap has no size; expected size = [width, height] beside st = \"texcoords\"");
    if (pixmap.width != 0 && pixmap.texels_per_unit != 0)
        table.fail("pixmap has both size and texels; expected one of them");
    return pixmap;
}

}  // namespace

void TomlObjects::add(const TomlValue& table) {
    ObjectTable object{table};
    Placement placement;
    const auto keep = [](std::string name, const TomlValue*& field) {
        return Key{std::move(name), [&field](const TomlValue& value) { field = &value; }};
    };
    std::vector<Key> keys{
        key("name", object.name),
        key("file", object.file),
        {"shape", [](const TomlValue&) {}},
        key("visible", object.visible),
        keep("material", object.material),
        keep("crease", object.crease),
        keep("parts", object.parts),
        key("move", object.placed.move),
        {"pixmap", [&](const TomlValue& value) { object.placed.pixmap = to_pixmap(value); }},
        {"glare", [&](const TomlValue& value) { object.placed.glare = to_glare(value); }},
        key("divide", object.divide, {1, 256}),
    };
    add_placement_keys(keys, placement);
    add_shape_keys(table, keys, object.shape);
    read_table(table, keys);
    object.placed.world_from_object = world_from_object(placement);
    if (object.file.empty() && !object.shape.make)
        table.fail("object has neither file nor shape; expected one of them");
    if (!object.file.empty() && object.shape.make)
        table.fail("object has both file and shape; expected one of them");
    object.shape.make ? add_shape(object) : add_file(object);
}

void TomlObjects::add_mesh(const ObjectTable& object, const std::string& name, MeshData mesh,
                           const Material& material) {
    names_.insert(name);
    if (!object.visible) return;
    Object placed = object.placed;
    placed.name = name;
    builder_.add(std::move(placed), divide(std::move(mesh), object.divide), material,
                 {*object.table.file, object.table.line});
}

MeshData TomlObjects::make_shape(const ObjectTable& object) const {
    try {
        return object.shape.make(object.shape.parameters);
    } catch (const Error& error) {
        object.table.fail(error.what());
    }
}

void TomlObjects::add_shape(const ObjectTable& object) {
    if (object.crease) object.crease->fail("crease beside shape; expected it beside file");
    if (object.parts) object.parts->fail("parts beside shape; expected it beside file");
    const std::string& name = object.name.empty() ? object.shape.name : object.name;
    add_mesh(object, name, make_shape(object), material_of(object, {}, {}));
}

void TomlObjects::add_file(const ObjectTable& object) {
    const ObjFile& file = file_of(object);
    const std::vector<std::string> wanted =
        object.parts ? to_strings(*object.parts) : std::vector<std::string>();
    for (const std::string& part : wanted)
        if (std::ranges::find(file.parts, part, &ObjPart::name) == file.parts.end())
            object.parts->fail(unknown("part", part, names_of(file.parts)));
    for (const ObjPart& part : file.parts) {
        if (!wanted.empty() && std::ranges::find(wanted, part.name) == wanted.end()) continue;
        const std::string& name = object.name.empty() ? part.name : object.name;
        add_mesh(object, name, part.mesh, material_of(object, file, part));
    }
}

const ObjFile& TomlObjects::file_of(const ObjectTable& object) {
    const TomlValue& value = *object.table.find("file");
    const std::filesystem::path path =
        find_file(std::filesystem::path(*value.file).parent_path(), object.file);
    if (!file_exists(path))
        value.fail("file '" + printable(object.file) + "' does not exist; expected an OBJ file");
    ObjOptions options;
    if (object.crease) options.crease = to_double(*object.crease, {0, 180});
    const auto found = files_.find({path.string(), options.crease.value_or(-1)});
    if (found != files_.end()) return found->second;
    return files_[{path.string(), options.crease.value_or(-1)}] =
               read_obj(path, options, warnings_);
}

const Material& TomlObjects::material_of(const ObjectTable& object, const ObjFile& file,
                                         const ObjPart& part) {
    const TomlValue* const value = object.material;
    if (!value)
        return find_material({&library_, &file.materials}, part.material,
                             {file.file, part.material_line});
    if (value->kind == TomlKind::String)
        return find_material({&library_, &file.materials}, value->text,
                             {*value->file, value->line});
    if (value->kind != TomlKind::Table) value->fail_expected("a name or a table");
    return changed_material(*value, find_material({&library_, &file.materials}, part.material,
                                                  {file.file, part.material_line}));
}

const Material& TomlObjects::changed_material(const TomlValue& changes, const Material& base) {
    const auto [found, is_new] = changed_.try_emplace({&changes, &base}, base);
    if (is_new) read_material(changes, found->second);
    return found->second;
}

}  // namespace gw::scene
