#include "scene/maps/mean.h"

#include "gw/base/arithmetic.h"
#include "scene/maps/map_lists.h"
#include "scene/maps/physical.h"

namespace gw::scene {
namespace {

TextureRef texel_of_mean(const Texture& texture, bool is_encoded) {
    const dvec3 mean = mean_of(texture, is_encoded);
    const dvec3 shown = is_encoded ? dvec3(encoded(mean)) : mean;
    std::vector<std::uint16_t> rgba;
    for (int k = 0; k < 3; ++k) rgba.push_back(std::uint16_t(quantize(shown[k], 16)));
    rgba.push_back(0xFFFF);
    return make_texture(texture.name, 1, 1, rgba);
}

}  // namespace

dvec3 mean_of(const Texture& texture, bool is_encoded) {
    const TexelValues& rgba = texture.levels.front().rgba;
    dvec3 sum(0);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const dvec3 texel = dvec3(rgba[i], rgba[i + 1], rgba[i + 2]) / 65535.0;
        sum += is_encoded ? decoded(texel) : texel;
    }
    return sum / double(rgba.size() / 4);
}

void replace_by_means(Scene& scene) {
    for (Material& material : scene.materials)
        for_each_color_map(material, [&](Map& map) {
            if (map.is_mean && map.texture)
                map.texture = texel_of_mean(*map.texture, material.is_encoded);
        });
}

dvec3 reflectance_of(const Material& material) {
    const dvec3 Kd(material.Kd);
    dvec3 share = material.is_encoded ? decoded(Kd) : Kd;
    for (const Map& map : material.map_Kd)
        if (map.texture) share *= mean_of(*map.texture, material.is_encoded);
    return share;
}

}  // namespace gw::scene
