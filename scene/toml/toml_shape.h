// The shape of an [[object]]: its name, and a key for each of its parameters. Does not place it.
#pragma once

#include "gw/mesh.h"
#include "scene/toml/toml_binder.h"

namespace gw::scene {

/// A shape that a table asks for, and what its parameters are set to.
struct TomlShape {
    std::string name;
    std::vector<double> parameters;
    std::function<MeshData(const std::vector<double>&)> make;  ///< empty: the table has no shape
};

/// Finds the shape of the table and appends its parameters' keys, which fill in `shape`; it must
/// stay where it is. Throws Error naming the nearest shape.
void add_shape_keys(const TomlValue& table, std::vector<Key>& keys, TomlShape& shape);

}  // namespace gw::scene
