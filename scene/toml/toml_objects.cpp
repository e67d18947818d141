#include "scene/toml/toml_objects.h"

#include "gw/error.h"
#include "scene/geometry/divide.h"
#include "scene/geometry/transform.h"
#include "scene/text/number.h"
#include "scene/text/statements.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/toml/luminous/toml_luminous.h"

#include <algorithm>
#include <new>

namespace gw::scene {

/// The keys of one table.
struct TomlObjects::ObjectTable {
    const TomlValue& table;
    std::string name, file;
    const TomlValue *material = nullptr, *crease = nullptr, *parts = nullptr;
    TomlShape shape;
    int divide = 1;
    bool visible = true;
    Object placed;                                         ///< without name, mesh and material
    std::map<const Material*, const Material*> changed{};  ///< by `material = {...}`

    Origin origin() const { return {*table.file, table.line}; }
};

namespace {

/// A scene refuses to generate more triangles: they would take about 1.5 GB.
constexpr double most_triangles = 1 << 25;

/// From this many objects on, objects of one shape share a mesh. Below, each mesh has identifiers
/// of its own, as in recordings.
constexpr std::size_t few_objects = 1000;

Glare to_glare(const TomlValue& table) {
    Glare glare;
    std::vector<Key> keys;
    visit_glare(glare, KeyList{keys});
    read_table(table, keys);
    return glare;
}

void read_sides(const TomlValue& value, PixmapChoice& pixmap) {
    expect_numbers(value, 2);
    pixmap.width = to_int(value.elements[0], pixmap_sides);
    pixmap.height = to_int(value.elements[1], pixmap_sides);
}

PixmapChoice to_pixmap(const TomlValue& table) {
    PixmapChoice pixmap;
    pixmap.origin = {*table.file, table.line};
    vec3 emission(0);
    double nit = 0;
    read_table(table, {
                          key("name", pixmap.name),
                          {"size", [&](const TomlValue& value) { read_sides(value, pixmap); }},
                          key("texels", pixmap.texels_per_unit, texels_per_unit),
                          key("st", pixmap.given_st, {{"automatic", false}, {"texcoords", true}}),
                          color_key("emission", emission),
                          key("lumen", pixmap.lumen, {1e-9, 1e12}),
                          key("nit", nit, {1e-9, 1e12}),
                          color_key("color", pixmap.color),
                      });
    if (table.find("emission")) pixmap.emission = emission;
    read_lamp(table, nit, pixmap);
    obey(table, fault_of(pixmap));
    return pixmap;
}

}  // namespace

TomlObjects::SourceFile::SourceFile(ObjFile read)
    : file(std::move(read.file)),
      list(std::move(read.materials)),
      materials(list, std::move(read.missing_library)) {
    for (ObjPart& part : read.parts)
        parts.push_back({.name = std::move(part.name),
                         .material = std::move(part.material),
                         .material_line = part.material_line,
                         .mesh = std::move(part.mesh),
                         .file_from_part = translation(part.origin)});
    for (const SourcePart& part : parts) names.insert(part.name);
}

TomlObjects::SourceFile::SourceFile(std::string path, GltfFile read)
    : file(std::move(path)),
      origin(read.origin),
      list{.materials = std::move(read.scene.materials), .faults = {}},
      materials(list) {
    for (Object& object : read.scene.objects)
        parts.push_back({.name = std::move(object.name),
                         .own = &list.materials[object.material],
                         .shared = std::move(object.mesh),
                         .file_from_part = object.world_from_object,
                         .single_sided = object.single_sided});
    for (const SourcePart& part : parts) names.insert(part.name);
}

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
        place_key("move", object.placed.move),
        {"pixmap", [&](const TomlValue& value) { object.placed.pixmap = to_pixmap(value); }},
        {"glare", [&](const TomlValue& value) { object.placed.glare = to_glare(value); }},
        key("divide", object.divide, {1, 256}),
    };
    add_placement_keys(keys, placement);
    add_shape_keys(table, keys, object.shape);
    read_table(table, keys);
    object.placed.world_from_object = world_from_object(placement);
    if (object.file.empty() && !object.shape.shape)
        table.fail("object has neither file nor shape; expected one of them");
    if (!object.file.empty() && object.shape.shape)
        table.fail("object has both file and shape; expected one of them");
    try {
        object.shape.shape ? add_shape(object) : add_file(object);
    } catch (const std::bad_alloc&) {
        table.fail("object needs more memory than there is; expected fewer triangles");
    }
}

void TomlObjects::count_triangles(const ObjectTable& object, double count) {
    triangles_ += count;
    if (triangles_ <= most_triangles) return;
    object.table.fail("object has " + number_text(count) + " triangles, this and all before it " +
                      number_text(triangles_) + "; expected at most " +
                      number_text(most_triangles) + " in shapes and divided files");
}

template <class Make>
void TomlObjects::add_mesh(ObjectTable& object, const std::string& name, const MeshKey& key,
                           const Material& material, const Make& make) {
    names_.insert(name);
    if (!object.visible) return;
    Object placed = object.placed;
    placed.name = name;
    if (placed.glare && material.Ke == vec3(0) && material.map_Ke.empty())
        warnings_.add(*object.table.file, object.table.line, "glare",
                      "glare has no effect on an object that does not emit; expected Ke");
    placed.material = builder_.index_of(material);
    if (builder_.scene.objects.size() < few_objects) {
        placed.mesh = builder_.numbered(divide(make(), object.divide), object.origin());
    } else {
        MeshRef& mesh = shared_[key];
        if (!mesh) mesh = builder_.numbered(divide(make(), object.divide), object.origin());
        placed.mesh = mesh;
    }
    builder_.scene.objects.push_back(std::move(placed));
}

void TomlObjects::add_shape(ObjectTable& object) {
    if (object.crease) object.crease->fail("crease beside shape; expected it beside file");
    if (object.parts) object.parts->fail("parts beside shape; expected it beside file");
    const Shape& shape = *object.shape.shape;
    const std::vector<double>& values = object.shape.parameters;
    const std::string& name = object.name.empty() ? shape.name : object.name;
    const double pieces = shape.is_flat ? object.divide : 1;
    if (object.visible) count_triangles(object, shape.triangles(values) * pieces * pieces);
    add_mesh(object, name, {nullptr, shape.name, values, object.divide},
             material_of(object, nullptr, nullptr), [&] {
                 try {
                     return shape.make(values);
                 } catch (const Error& error) {
                     object.table.fail(error.what());
                 }
             });
}

void TomlObjects::add_file(ObjectTable& object) {
    const SourceFile& source = file_of(object);
    if (const dvec3& origin = source.origin; origin != dvec3(0))
        object.placed.world_from_object = object.placed.world_from_object * translation(origin);
    const dmat4 world_from_file = object.placed.world_from_object;
    std::set<std::string> wanted;
    if (object.parts)
        for (std::string& part : to_strings(*object.parts)) {
            if (!source.names.contains(part))
                object.parts->fail(
                    unknown("part", part, {source.names.begin(), source.names.end()}));
            wanted.insert(std::move(part));
        }
    for (const SourcePart& part : source.parts) {
        if (!wanted.empty() && !wanted.contains(part.name)) continue;
        const std::string& name = object.name.empty() ? part.name : object.name;
        const MeshData& mesh = part.shared ? part.shared->data() : part.mesh;
        if (object.visible && object.divide > 1)
            count_triangles(object, divided_triangles(mesh, object.divide));
        if (part.file_from_part != dmat4(1))
            object.placed.world_from_object = world_from_file * part.file_from_part;
        object.placed.single_sided = part.single_sided;
        add_mesh(object, name, {&mesh, {}, {}, object.divide}, material_of(object, &source, &part),
                 [&] {
                     MeshData copy = mesh;
                     copy.polygon_ids.clear();
                     return copy;
                 });
        object.placed.world_from_object = world_from_file;
    }
}

const TomlObjects::SourceFile& TomlObjects::file_of(const ObjectTable& object) {
    const TomlValue& value = *object.table.find("file");
    const std::filesystem::path path =
        find_file(std::filesystem::path(*value.file).parent_path(), object.file);
    if (const std::string fault = file_fault(path); !fault.empty())
        value.fail("file '" + printable(object.file) + "' " + fault +
                   "; expected an OBJ or glTF file");
    const std::string extension = lower(path.extension().string());
    if (extension == ".gltf" || extension == ".glb") return gltf_of(object, path);
    if (extension != ".obj")
        value.fail("file '" + printable(object.file) + "' has the extension '" +
                   printable(extension) + "'; expected an OBJ or glTF file");
    ObjOptions options;
    if (object.crease) options.crease = to_double(*object.crease, {0, 180});
    const std::pair<std::string, double> key{path.string(), options.crease.value_or(-1)};
    const auto found = files_.find(key);
    if (found != files_.end()) return found->second;
    return files_.try_emplace(key, read_obj(path, options, warnings_)).first->second;
}

const TomlObjects::SourceFile& TomlObjects::gltf_of(const ObjectTable& object,
                                                    const std::filesystem::path& path) {
    if (object.crease) object.crease->fail("crease beside glTF; expected it beside an OBJ file");
    const std::pair<std::string, double> key{path.string(), -1};
    const auto found = files_.find(key);
    if (found != files_.end()) return found->second;
    GltfFile read = read_gltf(path, warnings_);
    const auto leave_out = [&](bool is_there, const std::string& what) {
        if (is_there)
            warnings_.add(path.string(), 0, what, what + " left out; the scene has its own");
    };
    leave_out(read.scene.camera.has_value(), "its camera is");
    leave_out(read.scene.white > 0, "its lights are");
    leave_out(!read.films.empty(), "its animations are");
    return files_.try_emplace(key, path.string(), std::move(read)).first->second;
}

const Material& TomlObjects::material_of(ObjectTable& object, const SourceFile* source,
                                         const SourcePart* part) {
    static const MaterialLibrary none;
    static const MaterialNames no_names(none);
    const MaterialNames& own = source ? source->materials : no_names;
    const auto base = [&]() -> const Material& {
        if (!part) return default_material();
        if (part->own) {
            const Material* const replaced = library_.find(part->own->name);
            return replaced ? *replaced : *part->own;
        }
        return material_of_faces({&library_, &own}, part->material,
                                 {source->file, part->material_line}, warnings_);
    };
    const TomlValue* const value = object.material;
    if (!value) return base();
    if (value->kind == TomlKind::String)
        return find_material({&library_, &own}, value->text, {*value->file, value->line});
    if (value->kind != TomlKind::Table) value->fail_expected("a name or a table");
    return changed_material(object, base());
}

const Material& TomlObjects::changed_material(ObjectTable& object, const Material& base) {
    const auto [found, is_new] = object.changed.try_emplace(&base);
    if (is_new) {
        changed_.push_back(base);
        read_material(*object.material, changed_.back());
        found->second = &changed_.back();
    }
    return *found->second;
}

}  // namespace gw::scene
