// PYM_HOLLOW: of a polygon's pixels those at its edge, in the colours that they have when it is filled.
#pragma once

#include "irisgl/draw/primitives.h"

#include <functional>

namespace gw::irisgl {

bool draws_hollow();
/// Draws the polygons of a shape one by one, each with `draw`. `outline`: of Shape::Polygon and of
/// what a concave polygon became; of other shapes it is not looked at.
void draw_hollow(Shape shape, std::span<const Vertex> vertices, std::span<const Vertex> outline,
                 const std::function<void(Shape, std::span<const Vertex>)>& draw);

}  // namespace gw::irisgl
