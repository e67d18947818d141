// Decides by a light's shadow maps [K3.2 a] whether a point is in its shadow: for the pixels of
// a picture (shadow_mask) and for hits of traced rays [K4i]. Does not draw the maps.
#pragma once

#include "gw/profile.h"
#include "multipass/shadow/shadow_map.h"
#include "scene/draw/view.h"
#include "scene/draw/world_triangles.h"

#include <cstdint>
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

/// 1 if the point that a pixel shows is in shadow or on the dark side of its face, else 0. `ids`:
/// scene::draw_item_buffer of the view, with the jitter of the passes that use the mask.
std::vector<std::uint32_t> shadow_mask(const scene::WorldTriangles& polygons,
                                       const scene::Light& light,
                                       const std::vector<ShadowMap>& maps,
                                       const std::vector<std::uint32_t>& ids,
                                       const scene::View& view, const JitterState& jitter,
                                       const Profile& profile);

}  // namespace gw::multipass
