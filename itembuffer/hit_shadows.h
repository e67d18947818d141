// Shadow maps for the hits of traced rays [K4i, K3.2 a]: every light's Z-buffer, drawn by the
// machine as for the passes, instead of shadow rays. As exact as the maps' texels. Does not shade
// first hits: the passes do.
#pragma once

#include "gw/machine.h"
#include "multipass/shadow/shadow_lookup.h"
#include "scene/scene.h"

#include <vector>

namespace gw::itembuffer {

/// The maps of all lights that cast shadows, for all views: made once while neither lights nor
/// objects move.
class HitShadows {
public:
    /// `scene` is the drawn one. Overwrites the machine's planes.
    HitShadows(Machine& machine, const scene::Scene& scene, int width, int height);
    HitShadows(const HitShadows&) = delete;

    /// As in raytrace::TraceOptions.
    bool in_shadow(std::size_t light, const scene::TrianglePoint& at) const {
        return lookups_[light].in_shadow(at);
    }

    /// The side of a map for a picture of this size: the power of two that is at least its longer
    /// side. Half that of the passes' maps, since reflections mostly show things smaller.
    static int size(int width, int height);

private:
    std::vector<std::vector<multipass::ShadowMap>> maps_;  ///< by light; none without a shadow
    std::vector<multipass::ShadowLookup> lookups_;
};

}  // namespace gw::itembuffer
