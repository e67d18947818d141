// [[object]]: parts of OBJ and glTF files and shapes, placed and given materials. docs/scenes.md has
// every key.
#pragma once

#include "scene/gltf/read_gltf.h"
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
    /// `library` holds the materials of the TOML file; they take precedence over those of other
    /// files.
    TomlObjects(SceneBuilder& builder, const MaterialLibrary& library, Warnings& warnings)
        : builder_(builder), library_(library), warnings_(warnings) {}
    TomlObjects(const TomlObjects&) = delete;
    TomlObjects& operator=(const TomlObjects&) = delete;

    /// Adds the objects of one table. Throws Error with file and line.
    void add(const TomlValue& table);

    /// Names of all objects, including invisible ones.
    const std::set<std::string>& names() const { return names_; }

private:
    struct ObjectTable;
    /// A part of an OBJ file names its material. One of glTF has the material itself, a place and a
    /// mesh that parts may share.
    struct SourcePart {
        std::string name, material;
        int material_line = 0;
        const Material* own = nullptr;
        MeshData mesh;
        MeshRef shared;
        dmat4 file_from_part{1};
        bool single_sided = false;
    };
    /// A file that was read, and its parts by their names.
    struct SourceFile {
        explicit SourceFile(ObjFile read);
        SourceFile(std::string path, GltfFile read);
        SourceFile(const SourceFile&) = delete;
        SourceFile& operator=(const SourceFile&) = delete;
        std::string file;
        dvec3 origin{0};  ///< of glTF
        MaterialLibrary list;
        MaterialNames materials;
        std::vector<SourcePart> parts;
        std::set<std::string_view> names;
    };
    /// The mesh of a file's part or a shape with its parameters, and its pieces
    /// (scene/geometry/divide.h).
    using MeshKey = std::tuple<const void*, std::string, std::vector<double>, int>;

    void add_file(ObjectTable& object);
    void add_shape(ObjectTable& object);
    void count_triangles(const ObjectTable& object, double count);
    template <class Make>
    void add_mesh(ObjectTable& object, const std::string& name, const MeshKey& key,
                  const Material& material, const Make& make);
    const SourceFile& file_of(const ObjectTable& object);
    const SourceFile& gltf_of(const ObjectTable& object, const std::filesystem::path& path);
    const Material& material_of(ObjectTable& object, const SourceFile* source,
                                const SourcePart* part);
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
