// Whether a point is in a light's shadow, by its shadow maps [K3.2 a]: for the pixels of a picture
// (shadow_mask) and for hits of traced rays [K4i]. Does not draw the maps.
#pragma once

#include "gw/profile.h"
#include "multipass/shadow/shadow_map.h"
#include "scene/geometry/world_triangles.h"

#include <vector>

namespace gw::multipass {

/// Refers to the maps, which must outlive it.
class ShadowLookup {
public:
    ShadowLookup(const std::vector<ShadowMap>& maps, const Profile& profile);

    /// Whether anything is nearer to the light than this point of a face. Outside all maps: false.
    bool in_shadow(const scene::TrianglePoint& at) const;

    /// A map, with the matrices and units of the comparison.
    struct Comparer {
        const ShadowMap& map;
        dmat4 clip_from_world;
        dmat4 clip_plane_from_world;  ///< inverse transpose: planes move by it
        double units;                 ///< of Z from -1 to 1
        double snap;                  ///< of a vertex, in texels
    };

private:
    std::vector<Comparer> comparers_;
};

}  // namespace gw::multipass
