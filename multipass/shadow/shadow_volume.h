// Shadow volumes [K3.2 b]: the space that an object keeps from a light, as a closed surface to be
// counted in the stencil buffer. Crow 1977; silhouettes of any mesh after Bergeron 1986. Geometry
// only: shadow_passes.h draws and counts.
//
// The front cap is a set of triangles of the object, turned to face the light. The far cap
// (far_cap.h) is the same set, moved away from the light beyond the whole scene. Sides join the
// borders of the two. For a mesh without border the set is the triangles that face the light. For
// any other mesh (open, not manifold) it is all triangles, each casting its own shadow; neighbours
// that cancel have no side between them.
#pragma once

#include "multipass/shadow/far_cap.h"
#include "multipass/shadow/topology.h"
#include "multipass/steps/pass_model.h"
#include "scene/draw/view.h"

#include <vector>

namespace gw::multipass {

/// The volume's surface, counter-clockwise from outside, in two meshes that are closed together.
struct ShadowVolume {
    /// Null: no triangle faces the light. The front cap has the mesh's positions, so the same Z.
    MeshRef caps;
    MeshRef sides;      ///< null: the front cap has no border
    scene::Bounds box;  ///< of both meshes, in the object's coordinates
    LightInObject light;
    WallsOfCap far_walls{};  ///< of the far cap
};
ShadowVolume shadow_volume(const Topology& topology, const LightInObject& light, bool mirrored);

/// The volumes of all parts in one light, by part; those of parts that cast no shadow have no caps.
/// Translucent parts cast none.
std::vector<ShadowVolume> shadow_volumes(const PassModel& model,
                                         const std::vector<TopologyRef>& topologies,
                                         std::size_t light);

/// The view with its far plane moved behind these volumes, so that it does not cut them.
scene::View enclosing(scene::View view, const PassModel& model,
                      const std::vector<ShadowVolume>& volumes);

/// Whether the sides alone decide which points are in the volume. No plane or guard band cuts the
/// surface, so its faces add up to 0 on every pixel, and the eye is outside. The near rectangle,
/// slightly widened, is on this side of the far cap, so no cap lies before anything of the scene.
bool is_outside(const ShadowVolume& volume, const dmat4& eye_from_object, const scene::View& view);

}  // namespace gw::multipass
