// The shadows of a frame: volumes, maps and masks by light, eq. 4 [K3.2]. Does not draw them
// (shadow_passes.h).
#pragma once

#include "gw/machine.h"
#include "gw/mesh.h"
#include "multipass/shadow/shadow_map.h"
#include "multipass/shadow/shadow_volume.h"
#include "multipass/shadow/topology.h"
#include "multipass/steps/pass_model.h"
#include "scene/draw/view.h"

#include <cstdint>
#include <vector>

namespace gw::multipass {

/// By light; empty for a light without that kind of shadow.
struct Shadows {
    std::vector<std::vector<ShadowVolume>> volumes;  ///< by part
    std::vector<std::vector<ShadowMap>> maps;        ///< drawn once for all views
    /// by pixel of the view: 0 if the light arrives
    std::vector<std::vector<std::uint32_t>> masks;
    bool one_by_one = false;  ///< volumes are counted one by one, behind the visible point
};

/// The topology of every part's mesh, found once per mesh; empty if no light casts a volume.
std::vector<TopologyRef> topologies(const PassModel& model);

/// Volumes of the lights that cast them; masks stay empty.
Shadows find_volumes(const PassModel& model, const std::vector<TopologyRef>& topologies);

/// Finds the masks of the lights with shadow maps for a view. Overwrites the machine's planes.
void find_masks(Shadows& shadows, Machine& machine, const PassModel& model, const scene::View& view,
                const JitterState& jitter);

/// The view with a far plane behind all volumes.
scene::View enclosing(scene::View view, const PassModel& model, const Shadows& shadows);

}  // namespace gw::multipass
