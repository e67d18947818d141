// A surface over a rectangle of parameters, as triangles or quads.
#pragma once

#include "gw/mesh.h"

#include <functional>

namespace gw::scene {

/// A corner of a grid, in object space, before it is rounded to float32.
struct GridVertex {
    dvec3 position, normal;
    dvec2 texcoord;
};

/// (columns + 1) x (rows + 1) vertices, at(column, row); counter-clockwise if columns go to the
/// right and rows up. Triangles with two corners at one position (poles) are left out; quads are
/// all kept.
MeshData make_grid(int columns, int rows, const std::function<GridVertex(int column, int row)>& at,
                   Primitive primitive = Primitive::Triangles);

/// Adds a mesh of the same primitive.
void append(MeshData& mesh, const MeshData& other);

}  // namespace gw::scene
