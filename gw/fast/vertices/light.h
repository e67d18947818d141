// Colours of many vertices at once: the lighting equation and the rounding of given colours, in
// vectors of doubles. docs/manual.md, "Lighting"; scalar twins: gw/stages/lighting.cpp, operation
// by operation, and quantize_color(). Does not transform positions to the window.
#pragma once

#include "gw/stages/vertex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::fast {

/// Sets colors[index], for each of `indices`, to the colour that run_vertex gives the vertex's
/// front (or back). Precondition: lighting is on.
void light_vertices(const VertexProgram& program, std::span<const std::uint32_t> indices, bool back,
                    std::span<Rgba> colors);

/// Vertex colours before rounding.
struct GivenColors {
    const std::vector<vec4>& all;
    std::span<const std::uint32_t> indices;
    int bits;
};
/// Sets colors[index], for each of `indices`, to quantize_color() of its given colour.
void quantize_colors(const GivenColors& given, std::span<Rgba> colors);

}  // namespace gw::fast
