// [[object]]: parts of OBJ files and shapes, placed and given materials. docs/scenes.md has every
// key.
#pragma once

#include "scene/obj/read_obj.h"
#include "scene/scene_builder.h"
#include "scene/toml/toml_sections.h"

#include <map>
#include <set>

namespace gw::scene {

class TomlObjects {
public:
    /// `library` holds the materials of the TOML file; they take precedence over those of the OBJ
    /// files.
    TomlObjects(SceneBuilder& builder, const std::vector<Material>& library, Warnings& warnings)
        : builder_(builder), library_(library), warnings_(warnings) {}

    /// Adds the objects of one table. Throws Error with file and line.
    void add(const TomlValue& table);

    /// Names of all objects, including invisible ones.
    const std::set<std::string>& names() const { return names_; }

private:
    struct ObjectTable;
    void add_file(const ObjectTable& object);
    void add_shape(const ObjectTable& object);
    MeshData make_shape(const ObjectTable& object) const;
    void add_mesh(const ObjectTable& object, const std::string& name, MeshData mesh,
                  const Material& material);
    const ObjFile& file_of(const ObjectTable& object);
    const Material& material_of(const ObjectTable& object, const ObjFile& file,
                                const ObjPart& part);
    const Material& changed_material(const TomlValue& changes, const Material& base);

    SceneBuilder& builder_;
    const std::vector<Material>& library_;
    Warnings& warnings_;
    /// read already, by path and crease angle
    std::map<std::pair<std::string, double>, ObjFile> files_;
    std::map<std::pair<const TomlValue*, const Material*>, Material> changed_;
    std::set<std::string> names_;
};

}  // namespace gw::scene
