// How a scene becomes draw commands: state of a view, placed meshes, lights in eye space, maps,
// identifiers. Knows no passes (multipass/ does) and no pixels: it makes commands.
#pragma once

#include "gw/command_list.h"
#include "scene/draw/view.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gw::scene {

/// The state that all passes of a view share: projection, Z compare Less with update, lighting with
/// a local viewer, both sides of a face lit (arbitrary models have no known inside).
State view_state(const View& view);

/// Whether lines of sight are parallel: the view vector is the same at all points.
inline bool is_orthographic(const View& view) {
    const dmat4& m = view.clip_from_eye;
    return m[0].w == 0 && m[1].w == 0 && m[2].w == 0;
}

/// An object's mesh in eye space, without material, lights or map.
Draw placed(const Object& object, const View& view);

/// Back faces of a single-sided object.
inline CullState cull_of(const Object& object) { return {.enable = object.single_sided}; }

/// A light in eye space. Its highlight colour is Is, or Id if the light has no Is.
gw::Light eye_light(const Light& light, const View& view);

/// MTL's material as the machine takes it; alpha = d.
gw::Material machine_material(const Material& material);

/// Whether the light lights the object: its `only` is empty or names it [K3.3].
bool lights_object(const Light& light, const Object& object);

/// A map's filter and wrap: mipmapped, modulating.
TextureState texture_state(const Map& map);

/// The mesh with texture coordinates scale * st + offset, since the machine has no texture matrix.
/// Returns the same mesh if the map changes nothing.
MeshRef mapped_mesh(const MeshRef& mesh, const Map& map);

/// The identifiers of a scene's polygons [K4i]. Object i has first[i], first[i] + 1, ... for its
/// mesh's own identifiers lowest[i], lowest[i] + 1, ..., even if objects share a mesh. first[0] is
/// 1; 0 is the background.
struct PolygonIds {
    std::vector<std::uint32_t> first, lowest;
    std::uint32_t end = 1;  ///< one more than the last identifier
};
PolygonIds polygon_ids(const Scene& scene);

/// A polygon of a scene: its object, and its ordinal in the object's mesh (the readers number
/// meshes without gaps).
struct PolygonRef {
    std::size_t object = 0;
    std::uint32_t polygon = 0;
    bool operator==(const PolygonRef&) const = default;
};
/// The polygon of identifier `id`; none for the background's.
std::optional<PolygonRef> polygon_of(const PolygonIds& ids, std::uint32_t id);

struct IdPass {
    const char* name = "item buffer";
    int shift = 0;             ///< identifiers are shifted right by this many bits
    bool opaque_only = false;  ///< objects with d < 1 are left out
    JitterState jitter;        ///< [K4a]
    ScissorState scissor;      ///< also of the clear; off: the view's rows
    ClipPlane clip;            ///< in eye space: a hemicube's horizon [F2.2]
};
/// The item buffer [K4i]: clears colour and depth and draws the identifier of every polygon instead
/// of its colour. The low 24 bits of (id >> shift) come out as R, G, B: eight bits each.
CommandList id_pass(const Scene& scene, const View& view, const IdPass& options = {});

/// The identifier that id_pass wrote as a colour.
inline std::uint32_t id_of(const Rgba& color) {
    return std::uint32_t(color[0]) | std::uint32_t(color[1]) << 8 | std::uint32_t(color[2]) << 16;
}

/// Draws every object without a material, for passes that only need Z.
void add_shapes(CommandList& list, const Scene& scene, const View& view);

}  // namespace gw::scene
