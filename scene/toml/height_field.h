// shape = "height_field": a grid of heights over x and z, as a mesh of quads with smooth normals.
#pragma once

#include "scene/toml/shape_table.h"

namespace gw::scene {

/// Its parameters are the numbers of columns and rows, then x of each column, z of each row, and the
/// heights row by row, as `read_height_field` gives them.
const Shape& height_field();

/// The values of the keys x, z and heights. Throws Error, at the key, unless x and z have 2 to 4096
/// increasing numbers and the heights a row for each z with a number for each x.
std::vector<double> read_height_field(const TomlValue& table);

}  // namespace gw::scene
