// A mesh, cut along the lines where its opacity reaches a level. Faces keep their corners, and cut
// faces that share a side have bit-equal points on it. Does not know materials.
#pragma once

#include "gw/mesh.h"
#include "scene/maps/opacity_pieces.h"

#include <optional>
#include <vector>

namespace gw::scene {

/// What cutting may take in all.
struct CutBudget {
    std::size_t cells = std::size_t{1} << 26;  ///< between texels
    std::size_t triangles = std::size_t{1} << 20;
};

/// What a mesh's colours are: a factor of the opacity, or colours, which its pieces have too.
enum class ColorUse { Opacity, Color };

/// The mesh's triangles, by level; empty ones have no positions. `map`, which may be null, has a
/// texture; its alpha, times that of the vertices' colours if they are so used, is the opacity. A
/// triangle is turned as in the mesh. None if it would take more than the budget, of which it takes
/// its part.
std::optional<std::vector<MeshData>> cut_by_opacity(const Mesh& mesh, const Map* map, ColorUse use,
                                                    const OpacityLevels& levels, CutBudget& budget);

}  // namespace gw::scene
