// Meshes whose vertices move, by morph targets [GLTF2 3.7.2.2] and skins [GLTF2 3.7.3], and the faces
// that are drawn of them. Does not read files.
#pragma once

#include "gw/mesh.h"
#include "gw/texture.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gw::scene {

/// What a morph target adds, times its weight: to each vertex, or nothing.
struct MorphTarget {
    std::vector<vec3> positions, normals;
};

/// A joint that moves a vertex.
struct Influence {
    std::uint32_t joint = 0;
    float weight = 0;
};

/// A primitive as the file has it.
struct GltfMesh {
    MeshData mesh;  ///< without polygon_ids; faces without normals are to be flat. Colours: white,
                    ///< if their alphas differ
    /// of the vertex colours; none: there are none
    std::optional<vec4> mean_color;
    std::vector<vec4> colors;           ///< linear, of each vertex; empty: all are mean_color
    std::vector<vec2> other_texcoords;  ///< a second set, or none
    /// above 0: its texture coordinates are those of patches of this side (maps/patches.h)
    std::size_t patch_side = 0;
    std::vector<MorphTarget> targets;
    std::size_t influences = 0;  ///< of each vertex
    std::vector<Influence>
        influenced;          ///< those of vertex 0, then of vertex 1, ...; weights add to 1
    std::size_t joints = 0;  ///< one more than the largest
};

/// The number of triangles; 0 of points and lines.
std::size_t triangle_count(const MeshData& mesh);

/// Whether its colours can be a texture; else they are drawn as their mean.
bool has_color_texture(const GltfMesh& mesh);
/// Gives the mesh the coordinates of this texture; how many texels that has.
std::size_t patch_colors(GltfMesh& mesh);
/// The vertex colours, with a patch of texels for each triangle, encoded as in sRGB.
TextureRef color_texture(const GltfMesh& mesh);

/// Gives the mesh patches for maps of both sets of coordinates, and the material's maps these look-ups:
/// those that are means have the other set. How many texels a map has then: at most `texels`; 0 if it is
/// left as it was, since it has no triangles, lacks coordinates or would need more.
std::size_t patch_maps(GltfMesh& mesh, Material& material, std::size_t texels);

/// Meshes of one colour each, at most 64: the mean of their triangles' means, in steps of 1/255. Those
/// with a corner that differs from it by more than 1/16 keep their colours. The mesh itself if it has no
/// colours or triangles.
std::vector<GltfMesh> by_color(GltfMesh mesh);

/// Vertices moved by the weights of targets (fewer weights: the rest is 0), then by their joints'
/// matrices (empty: no skin). None if a vertex lies beyond 1e18. Precondition: a matrix for each joint.
std::optional<MeshData> moved(const GltfMesh& mesh, std::span<const double> weights,
                              std::span<const dmat4> object_from_rest);

/// As it is drawn: triangles of their own if they are flat, or have patches.
MeshData drawn(const GltfMesh& mesh, MeshData moved);

/// An object whose vertices move.
struct GltfShaped {
    std::size_t object = 0;  ///< into the scene's
    std::size_t node = 0;    ///< into the list of placed_nodes
    std::shared_ptr<const GltfMesh> mesh;
    std::shared_ptr<const GltfSkin> skin;  ///< null: the node places it
    std::vector<double> weights;           ///< of the morph targets
    dvec3 base{0};  ///< of a skin: the point of the world from which its vertices are counted
};

/// Its vertices for these places of nodes, with identifiers. None as of `moved`.
std::optional<MeshData> posed(const GltfShaped& shaped, const std::vector<GltfNode>& nodes,
                              const std::vector<std::uint32_t>& polygon_ids);

}  // namespace gw::scene
