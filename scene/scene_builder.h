// Puts a scene together: numbers its polygons, and takes each material once, when an object first uses it.
// Does not read files.
#pragma once

#include "scene/read_obj.h"
#include "scene/scene.h"

#include <map>

namespace gw::scene {

class SceneBuilder {
public:
    Scene scene;

    /// `material` must stay where it is; `origin` is what an error of make_mesh is said to come from.
    void add(const std::string& name, MeshData mesh, const Material& material, const dmat4& world_from_object,
             const Origin& origin);

private:
    std::size_t index_of(const Material& material);

    std::map<const Material*, std::size_t> indices_;
    std::uint32_t next_polygon_ = 0;
};

/// What a surface is made of where nobody says: gw::Material's initial values, by the name "default".
const Material& default_material();

/// The first material of this name, or null.
const Material* find_material(const std::vector<Material>& materials, std::string_view name);

/// The material that a part of an OBJ file asks for: the default one where it asks for none.
/// Throws Error with the line of its usemtl where no MTL file has it.
const Material& material_in(const ObjFile& file, const ObjPart& part);

}  // namespace gw::scene
