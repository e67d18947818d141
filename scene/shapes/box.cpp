#include "scene/shapes/shapes.h"

#include "scene/shapes/grid.h"

#include <glm/geometric.hpp>

namespace gw::scene {
namespace {

// A rectangle about `center` with half sides `right` and `up`.
MeshData face(dvec3 center, dvec3 right, dvec3 up, int columns, int rows) {
    const dvec3 normal = glm::cross(right, up);
    // -1 .. 1, exactly symmetric, so that the borders of two faces are bit-equal.
    const auto across = [](int i, int n) { return static_cast<double>(2 * i - n) / n; };
    return make_grid(
        columns, rows,
        [&](int column, int row) {
            const dvec3 position =
                center + across(column, columns) * right + across(row, rows) * up;
            return GridVertex{
                position,
                normal,
                {static_cast<double>(column) / columns, static_cast<double>(row) / rows}};
        },
        Primitive::Quads);
}

// The right and up directions of a face that looks along an axis; their cross product is that axis.
struct BoxFace {
    dvec3 out, right, up;
};

constexpr BoxFace faces[6] = {
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},    //
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},   //
    {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},  //
    {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   //
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},   //
    {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
};

MeshData six_faces(dvec3 half, double turn, int segments) {
    MeshData mesh{.primitive = Primitive::Quads};
    for (const BoxFace& f : faces)
        append(mesh, face(turn * f.out * half, f.right * half, f.up * half, segments, segments));
    return mesh;
}

}  // namespace

MeshData make_rectangle(double width, double depth, int columns, int rows) {
    return face({0, 0, 0}, {width / 2, 0, 0}, {0, 0, -depth / 2}, columns, rows);
}

MeshData make_box(dvec3 size, int segments) { return six_faces(size / 2.0, 1, segments); }

// The face that looks along +z is at the far side, -z.
MeshData make_room(dvec3 size, int segments) { return six_faces(size / 2.0, -1, segments); }

}  // namespace gw::scene
