// Generated texture coordinates of a geometry set's vertices. Does not light.
#pragma once

#include "gw/stages/vertex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::fast {

/// texture_coordinates() of gw/stages/texgen.h, bounded, for the mesh's vertices `indices`: strq[i]
/// for each.
void generate_texcoords(const VertexProgram& program, std::size_t unit,
                        std::span<const std::uint32_t> indices, std::span<dvec4> strq);

}  // namespace gw::fast
