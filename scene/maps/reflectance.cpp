#include "scene/maps/reflectance.h"

#include "scene/maps/mean.h"
#include "scene/maps/physical.h"

namespace gw::scene {
dvec3 reflectance_of(const Material& material) {
    const dvec3 Kd(material.Kd);
    dvec3 share = material.is_encoded ? decoded(Kd) : Kd;
    for (const Map& map : material.map_Kd)
        if (map.texture) share *= mean_of(*map.texture, material.is_encoded);
    return share;
}

}  // namespace gw::scene
