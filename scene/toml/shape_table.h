// The shapes of a scene file by name: `shape = "torus"` with its parameters as keys.
// docs/scenes.md. Does not place them or give them materials.
#pragma once

#include "gw/mesh.h"
#include "scene/toml/toml_binder.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::scene {

struct ShapeParameter {
    std::string name;
    double value;      ///< the default
    double low, high;  ///< allowed, ends included
    bool integer;
};

/// Object space: y up; counter-clockwise from outside; positions, normals of length 1, texcoords.
/// Borders that meet have bit-equal positions. Vases, the teapot and the pedestal stand on y = 0;
/// other shapes have the origin in their middle. Curved shapes are Triangles, flat ones Quads.
struct Shape {
    std::string name;
    std::vector<ShapeParameter> parameters;
    /// Both take one value for each parameter, in order.
    std::function<MeshData(const std::vector<double>& values)> make;
    /// The number of triangles that `make` would give, or a few more.
    std::function<double(const std::vector<double>& values)> triangles;
    bool is_flat = false;  ///< of quads, which scene/geometry/divide.h divides
};

/// All that numbers describe, by name in alphabetical order; height_field.h has another.
const std::vector<Shape>& shapes();

/// A shape that an [[object]] asks for, and the values of its parameters.
struct TomlShape {
    const Shape* shape = nullptr;  ///< null: the table has none
    std::vector<double> parameters;
};
/// Finds the shape of the table and appends its parameters' keys, which fill in `shape`; it must
/// not move meanwhile.
void add_shape_keys(const TomlValue& table, std::vector<Key>& keys, TomlShape& shape);

}  // namespace gw::scene
