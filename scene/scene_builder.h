// Builds a scene: numbers its polygons, and adds each material when an object first uses it. Does
// not read files.
#pragma once

#include "gw/mesh.h"
#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>

namespace gw::scene {

class SceneBuilder {
public:
    Scene scene;

    /// Adds an object. `material` must not move; errors of make_mesh are reported at `origin`.
    void add(Object object, MeshData mesh, const Material& material, const Origin& origin);

    /// The mesh with the scene's next identifiers.
    MeshRef numbered(MeshData mesh, const Origin& origin);

    /// The index of a material in the scene; adds it when it is first asked for. It must not move.
    std::size_t index_of(const Material& material);

private:
    std::unordered_map<const Material*, std::size_t> indices_;
    std::uint32_t next_polygon_ = 0;
};

/// The material of surfaces without one: gw::Material's initial values, named "default".
const Material& default_material();

/// Drops Ks of a material whose illum is 0 or 1, as MTL says, unless it has a reflection map (which
/// Ks weighs). Returns whether it had one.
bool without_highlights(Material& material);

/// Adds a warning for each material in use that cannot be seen.
void warn_invisible(const Scene& scene, const std::string& file, Warnings& warnings);

/// The materials of files, in order. A fault in one that nothing uses is no error.
struct MaterialLibrary {
    std::vector<Material> materials;
    std::map<std::string, std::string, std::less<>> faults;  ///< messages, by the material's name

    void add(MaterialLibrary more);
};

/// Materials by name; of several with one name, the first. The library must not change meanwhile.
class MaterialNames {
public:
    /// `missing`: for people, why the library lacks some; empty: it is whole.
    explicit MaterialNames(const MaterialLibrary& library, std::string missing = {});

    /// Null if there is none. Throws Error for one with a fault.
    const Material* find(std::string_view name) const;
    const std::vector<Material>& list() const { return library_->materials; }
    const std::string& missing() const { return missing_; }

private:
    const MaterialLibrary* library_ = nullptr;
    std::string missing_;
    std::unordered_map<std::string_view, const Material*> by_name_;
};

/// The first material of this name in the lists, in their order; the default one for an empty name.
/// Throws Error from `origin`, naming the nearest material, if there is none.
const Material& find_material(std::initializer_list<const MaterialNames*> lists,
                              std::string_view name, const Origin& origin);

/// The material that a file's faces name, as find_material does; if there is none, a warning, and the
/// default one.
const Material& material_of_faces(std::initializer_list<const MaterialNames*> lists,
                                  std::string_view name, const Origin& origin, Warnings& warnings);

/// Numbers the mesh's polygons (faces, segments, points) next, next + 1, ... in their order, moves
/// `next` behind them and makes the mesh. Throws Error as make_mesh does.
MeshRef make_numbered_mesh(MeshData data, std::uint32_t& next);

}  // namespace gw::scene
