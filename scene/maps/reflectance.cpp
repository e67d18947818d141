#include "scene/maps/reflectance.h"

#include "scene/maps/physical.h"

namespace gw::scene {
namespace {

dvec3 mean_of(const Texture& texture, bool is_encoded) {
    const TexelValues& rgba = texture.levels.front().rgba;
    dvec3 sum(0);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const dvec3 texel = dvec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 65535.0;
        sum += is_encoded ? decoded(texel) : texel;
    }
    return sum / double(rgba.size() / 4);
}

}  // namespace

dvec3 reflectance_of(const Material& material) {
    const dvec3 Kd(material.Kd);
    dvec3 share = material.is_encoded ? decoded(Kd) : Kd;
    for (const Map& map : material.map_Kd)
        if (map.texture) share *= mean_of(*map.texture, material.is_encoded);
    return share;
}

}  // namespace gw::scene
