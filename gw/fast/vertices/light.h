// Lit colours of many vertices at once: the lighting equation in vectors of doubles.
// docs/manual.md, "Lighting"; scalar twin: gw/stages/lighting.cpp, operation by operation. Does not
// transform positions to the window.
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

}  // namespace gw::fast
