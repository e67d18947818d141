// The shadows of a frame: what each light needs before its stencil can be made. eq. 4 [K3.2].
// Does not draw: shadow_volume.h, shadow_passes.h and shadow_map.h do.
#pragma once

#include "gw/machine.h"
#include "gw/mesh.h"
#include "multipass/frame/pass_model.h"
#include "multipass/shadow/shadow_map.h"
#include "multipass/shadow/shadow_volume.h"
#include "multipass/shadow/topology.h"
#include "scene/draw/view.h"

#include <cstdint>
#include <vector>

namespace gw::multipass {

/// By light; empty for a light without that kind of shadow.
struct Shadows {
    std::vector<std::vector<ShadowVolume>> volumes;  ///< by part
    std::vector<std::vector<ShadowMap>> maps;        ///< drawn once, serve every view
    /// by pixel of the view: 0 where the light arrives
    std::vector<std::vector<std::uint32_t>> masks;
    bool one_by_one = false;  ///< volumes are counted one by one, all of them behind what is seen
};

/// The topology of every part's mesh (each mesh worked out once); empty where no light casts a
/// volume.
std::vector<Topology> topologies(const Model& model);

/// Volumes of the lights that cast them; masks stay empty.
Shadows find_volumes(const Model& model, const std::vector<Topology>& topologies);

/// Finds the masks of the lights with shadow maps for a view. The machine's planes are used, and
/// left as they come.
void find_masks(Shadows& shadows, Machine& machine, const Model& model, const scene::View& view,
                const JitterState& jitter);

/// The view with a far plane that cuts no volume.
scene::View enclosing(scene::View view, const Model& model, const Shadows& shadows);

}  // namespace gw::multipass
