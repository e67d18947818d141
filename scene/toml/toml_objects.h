// [[object]]: parts of OBJ files and shapes, placed and given materials. docs/scenes.md has every
// key.
#pragma once

#include "scene/obj/read_obj.h"
#include "scene/scene_builder.h"
#include "scene/toml/shape_table.h"
#include "scene/toml/toml_sections.h"

#include <deque>
#include <map>
#include <set>
#include <tuple>

namespace gw::scene {

class TomlObjects {
public:
    /// `library` holds the materials of the TOML file; they take precedence over those of the OBJ
    /// files.
    TomlObjects(SceneBuilder& builder, const std::vector<Material>& library, Warnings& warnings)
        : builder_(builder), library_(library), warnings_(warnings) {}
    TomlObjects(const TomlObjects&) = delete;
    TomlObjects& operator=(const TomlObjects&) = delete;

    /// Adds the objects of one table. Throws Error with file and line.
    void add(const TomlValue& table);

    /// Names of all objects, including invisible ones.
    const std::set<std::string>& names() const { return names_; }

private:
    struct ObjectTable;
    /// A file that was read, and its parts by their names.
    struct SourceFile {
        explicit SourceFile(ObjFile read);
        SourceFile(const SourceFile&) = delete;
        SourceFile& operator=(const SourceFile&) = delete;
        ObjFile file;
        MaterialNames materials;
        std::set<std::string_view> parts;
    };
    /// A part of a file or a shape with its parameters, and its pieces (scene/geometry/divide.h).
    using MeshKey = std::tuple<const ObjPart*, std::string, std::vector<double>, int>;

    void add_file(ObjectTable& object);
    void add_shape(ObjectTable& object);
    void count_triangles(const ObjectTable& object, double count);
    template <class Make>
    void add_mesh(ObjectTable& object, const std::string& name, const MeshKey& key,
                  const Material& material, const Make& make);
    const SourceFile& file_of(const ObjectTable& object);
    const Material& material_of(ObjectTable& object, const SourceFile* source, const ObjPart* part);
    const Material& changed_material(ObjectTable& object, const Material& base);

    SceneBuilder& builder_;
    const MaterialNames library_;
    Warnings& warnings_;
    /// read already, by path and crease angle
    std::map<std::pair<std::string, double>, SourceFile> files_;
    std::deque<Material> changed_;  ///< materials of `material = {...}`; they do not move
    std::map<MeshKey, MeshRef> shared_;
    double triangles_ = 0;  ///< of all shapes and divided files
    std::set<std::string> names_;
};

}  // namespace gw::scene
