// The pass lists of the paper's two renderers, and the list of each component's image. Does not
// draw.
#pragma once

#include "gw/profile.h"
#include "multipass/passes/pass.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace gw::multipass {

enum class Renderer { Hardware, Multipass };

/// How translucent objects (d < 1) are ordered [K3.4]. Sorted: their polygons, far to near, by
/// their centroids. Unsorted: as the scene has them; wrong where they overlap. Layers: pixel by
/// pixel, exactly (layers.h).
enum class Translucency { Sorted, Unsorted, Layers };

/// Eq. 1 in one pass [K2], or eq. 2 and 4 component by component [K3, K3.2], with the translucent
/// passes [K3.4] and the fog [K3.5] that the scene needs. If the scene's background is not black,
/// the depth pass also draws all shapes black: components are added to it.
PassList passes_for(const scene::Scene& scene, Renderer renderer,
                    Translucency translucency = Translucency::Sorted);

bool has_translucent(const scene::Scene& scene);

/// A component's image (Fig. 4): its name and the passes that draw it alone.
struct ComponentList {
    std::string name;
    PassList passes;
    bool background = false;  ///< on the scene's background; else on black
};

/// One per additive pass, in order, and first the background where that is not black. Their images,
/// added with saturation, are the picture of the whole list bit for bit: adding in another order
/// changes no saturated sum.
std::vector<ComponentList> component_lists(const scene::Scene& scene, const PassList& passes);

/// Throws Error if one pass with all lights has more lights on an object than the profile allows in
/// a pass. The message names the limit and the multi-pass renderer, which has none [K3p].
void check_lights(const scene::Scene& scene, const PassList& passes, const Profile& profile);

}  // namespace gw::multipass
