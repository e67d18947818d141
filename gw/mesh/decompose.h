// Strips, fans, quads and polygons as separate lines and triangles. docs/manual/geometry.md,
// "Primitives". Does not check its input: make_mesh does.
#pragma once

#include "gw/mesh.h"

namespace gw {

/// `corners`: indices into the vertices, in the order given.
std::vector<std::array<std::uint32_t, 2>> decompose_lines(Primitive primitive,
                                                          std::span<const std::uint32_t> corners);
std::vector<Triangle> decompose_triangles(const MeshData& data,
                                          std::span<const std::uint32_t> corners);

}  // namespace gw
