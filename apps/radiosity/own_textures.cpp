#include "apps/radiosity/own_textures.h"

#include "gw/base/arithmetic.h"
#include "image/write.h"
#include "scene/maps/mean.h"
#include "scene/maps/physical.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::apps {
namespace {

image::Picture own_picture(const TextureLevel& level, bool is_encoded) {
    image::Picture picture{level.width, level.height, 3, 8, {}};
    for (std::size_t i = 0; i < level.rgba.size(); i += 4) {
        const dvec3 texel = dvec3(level.rgba[i], level.rgba[i + 1], level.rgba[i + 2]) / 65535.0;
        const dvec3 shown = is_encoded ? texel : dvec3(scene::encoded(texel));
        for (int c = 0; c < 3; ++c) picture.values.push_back(std::uint16_t(quantize(shown[c], 8)));
    }
    return picture;
}

}  // namespace

std::optional<std::size_t> OwnTextures::of(const scene::Object& object,
                                           const scene::Material& material,
                                           image::OutputSet& files) {
    const bool emits = object.pixmap.emission.value_or(material.Ke) != vec3(0);
    if (emits || material.map_Kd.size() != 1 || object.mesh->data().texcoords.empty())
        return std::nullopt;
    const scene::Map& map = material.map_Kd[0];
    if (!map.texture || map.texture->levels.front().rgba.size() <= 4) return std::nullopt;
    const Key key{map.texture.get(), map.wrap_s, map.wrap_t, material.is_encoded};
    const auto found = std::ranges::find(keys_, key);
    if (found != keys_.end()) return std::size_t(found - keys_.begin());
    keys_.push_back(key);
    std::filesystem::path file = stem_;
    file += fmt::format("own_texture_{}.png", keys_.size());
    image::put_picture(files.add(file),
                       own_picture(map.texture->levels.front(), material.is_encoded));
    written_.push_back({file.filename().string(), map.wrap_s, map.wrap_t,
                        scene::mean_of(*map.texture, material.is_encoded)});
    return keys_.size() - 1;
}

}  // namespace gw::apps
