// Builds a scene: numbers its polygons, and adds each material when an object first uses it. Does
// not read files.
#pragma once

#include "scene/scene.h"

#include <initializer_list>
#include <map>
#include <string_view>

namespace gw::scene {

class SceneBuilder {
public:
    Scene scene;

    /// Fills in the object's mesh and material. `material` must not move; errors of make_mesh are
    /// reported at `origin`.
    void add(Object object, MeshData mesh, const Material& material, const Origin& origin);

private:
    std::size_t index_of(const Material& material);

    std::map<const Material*, std::size_t> indices_;
    std::uint32_t next_polygon_ = 0;
};

/// The material of surfaces without one: gw::Material's initial values, named "default".
const Material& default_material();

/// The first material of this name in the lists, in their order; the default one for an empty name.
/// Throws Error from `origin`, naming the nearest material, if there is none.
const Material& find_material(std::initializer_list<const std::vector<Material>*> lists,
                              std::string_view name, const Origin& origin);

}  // namespace gw::scene
