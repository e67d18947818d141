#include "scene/geometry/far.h"
#include "scene/obj/read_mtl.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/toml/luminous/toml_luminous.h"
#include "scene/toml/toml_film.h"
#include "scene/toml/toml_objects.h"
#include "scene/toml/toml_view.h"

#include <algorithm>

namespace gw::scene {
namespace {

/// The tables of [[light]], [[object]] or [[pass]]; a single [light] counts as one.
std::vector<const TomlValue*> tables_in(const TomlValue& value) {
    if (value.kind == TomlKind::Table) return {&value};
    if (value.kind != TomlKind::Array) value.fail_expected("[[" + value.name + "]]");
    std::vector<const TomlValue*> list;
    for (const TomlValue& element : value.elements) list.push_back(&element);
    return list;
}

// The materials of [material.NAME], then those of the mtllib files.
class LibraryReader {
public:
    explicit LibraryReader(Warnings& warnings) : warnings_(warnings) {}
    MaterialLibrary library;

    void add_table(const TomlValue& table) {
        if (table.kind != TomlKind::Table) table.fail_expected("[material.NAME]");
        for (const TomlValue& value : table.elements) {
            Material material{.name = value.key};
            read_material(value, material);
            library.materials.push_back(std::move(material));
        }
    }
    void add_files(const TomlValue& value) {
        for (const std::string& name : to_strings(value)) {
            const std::filesystem::path path =
                find_file(std::filesystem::path(*value.file).parent_path(), name);
            if (const std::string fault = file_fault(path); !fault.empty())
                value.fail("mtllib '" + printable(name) + "' " + fault + "; expected an MTL file");
            library.add(read_mtl(path, warnings_));
        }
    }

private:
    Warnings& warnings_;
};

// Lights and passes that name parts [K3.3] must name existing ones.
void check_names(const TomlValue& list, const std::set<std::string>& names) {
    for (const std::string& name : to_strings(list))
        if (!names.contains(name)) list.fail(unknown("object", name, {names.begin(), names.end()}));
}

void check_passes(const std::vector<TomlValue>& passes, const std::set<std::string>& names) {
    for (const TomlValue& pass : passes)
        if (const TomlValue* objects = pass.find("objects"))
            if (objects->kind == TomlKind::Array) check_names(*objects, names);
}

}  // namespace

SceneFile read_toml(const std::filesystem::path& path) {
    const TomlTables tables(path, "object");
    const TomlValue& file = tables.rest();
    if (file.find("base")) return read_view(path, file);
    SceneBuilder builder;
    Scene& scene = builder.scene;
    scene.name = path.stem().string();
    Warnings warnings;
    std::vector<const TomlValue*> lights, objects, passes, tracks;
    const TomlValue *materials = nullptr, *mtllib = nullptr, *film = nullptr;

    // Sections may come in any order, so references are read last.
    read_table(file,
               {
                   key("name", scene.name),
                   color_key("background", scene.background),
                   {"white", [&](const TomlValue& value) { scene.white = to_white(value); }},
                   key("texels", scene.texels_per_unit, texels_per_unit),
                   key("reflection_in_shadow", scene.reflection_in_shadow),
                   {"camera", [&](const TomlValue& value) { scene.camera = to_camera(value); }},
                   {"fog", [&](const TomlValue& value) { scene.fog = to_fog(value, warnings); }},
                   {"mtllib", [&](const TomlValue& value) { mtllib = &value; }},
                   {"material", [&](const TomlValue& value) { materials = &value; }},
                   {"light", [&](const TomlValue& value) { lights = tables_in(value); }},
                   {"object", [&](const TomlValue& value) { objects = tables_in(value); }},
                   {"pass", [&](const TomlValue& value) { passes = tables_in(value); }},
                   {"film", [&](const TomlValue& value) { film = &value; }},
                   {"track", [&](const TomlValue& value) { tracks = tables_in(value); }},
               });
    LibraryReader named(warnings);
    if (materials) named.add_table(*materials);
    if (mtllib) named.add_files(*mtllib);

    TomlObjects reader(builder, named.library, warnings);
    for (const TomlValue* object : objects) reader.add(*object);
    for (std::size_t i = 0; i < tables.pieces(); ++i)
        for (const TomlValue& object : tables.further(i)) reader.add(object);
    if (scene.objects.empty())
        throw Error(path.string(), objects.empty() ? 0 : objects[0]->line,
                    "has nothing to draw; expected an [[object]] that is visible");
    for (const TomlValue* light : lights) {
        scene.lights.push_back(to_light(*light, {scene.white, warnings}));
        if (const TomlValue* only = light->find("only")) check_names(*only, reader.names());
    }
    const dvec3 origin = far_origin(scene);
    if (origin != dvec3(0)) {
        count_from(scene, origin);
        for (std::size_t i = 0; i < lights.size(); ++i)
            scene.lights[i] = to_light(*lights[i], {scene.white, warnings, origin});
    }
    warn_invisible(scene, path.string(), warnings);
    warnings.add_file(path);
    std::vector<Film> films;
    if (auto moving = read_film(film, tracks, scene, origin)) films.push_back(*std::move(moving));
    SceneFile result{std::move(scene), warnings.lines(), {},
                     warnings.files(), origin,           std::move(films)};
    for (const TomlValue* pass : passes) result.passes.push_back(*pass);
    check_passes(result.passes, reader.names());
    return result;
}

}  // namespace gw::scene
