// A height field in a scene: y over a grid of x and z, every cell a quadrilateral or two triangles.
// Does not draw.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

/// A cell between neighbouring columns and strips.
struct FieldCell {
    /// convex: one quadrilateral or two triangles, in the world
    std::vector<Loop> loops;
    /// the sides of its polygons; a loop's other sides are not drawn
    std::vector<std::pair<dvec3, dvec3>> sides;
    std::uint32_t id = 0;
};

struct HeightField {
    int across = 0, sweep = 2;            ///< axes: 0 is x, 2 is z
    std::vector<double> columns, strips;  ///< coordinates along `across` and `sweep`, ascending
    std::vector<FieldCell> cells;         ///< [strip * (columns - 1) + column]
    const FieldCell& at(std::size_t strip, std::size_t column) const {
        return cells[strip * (columns.size() - 1) + column];
    }
};

/// All polygons of the scene as one height field, swept along z or x: an eye beside it sees the
/// strips one behind the other. Throws Error if the polygons are no height field, or the eye is
/// above it.
HeightField height_field(const Input& input);

}  // namespace gw::hiddensurface
