// Puts a scene together: numbers its polygons, and takes each material once, when an object first
// uses it.
// Does not read files.
#pragma once

#include "scene/scene.h"

#include <initializer_list>
#include <map>
#include <string_view>

namespace gw::scene {

class SceneBuilder {
public:
    Scene scene;

    /// Fills in the object's mesh and material. `material` must stay where it is; `origin` is what
    /// an error of make_mesh is said to come from.
    void add(Object object, MeshData mesh, const Material& material, const Origin& origin);

private:
    std::size_t index_of(const Material& material);

    std::map<const Material*, std::size_t> indices_;
    std::uint32_t next_polygon_ = 0;
};

/// What a surface is made of where nobody says: gw::Material's initial values, by the name
/// "default".
const Material& default_material();

/// The first material of this name in the lists, in their order; the default one where the name is
/// empty.
/// Throws Error from `origin`, naming the nearest material, where there is none.
const Material& find_material(std::initializer_list<const std::vector<Material>*> lists,
                              std::string_view name, const Origin& origin);

}  // namespace gw::scene
