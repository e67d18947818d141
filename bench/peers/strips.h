// Triangles in OpenGL's strips: fewer indices, each vertex looked at about once. Does not draw.
#pragma once

#include "gw/mesh.h"

#include <vector>

namespace gw::peers {

/// Indices of one GL_TRIANGLE_STRIP that draws the mesh's triangles with their winding: strips as
/// long as a walk across shared edges finds them, joined by triangles without area.
std::vector<unsigned> one_strip(const Mesh& mesh);

}  // namespace gw::peers
