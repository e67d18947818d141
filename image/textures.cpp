#include "image/textures.h"

#include "gw/error.h"

#include <map>

namespace gw::image {
namespace {

using Cache = std::map<std::filesystem::path, TextureRef>;

std::filesystem::path key_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto real = std::filesystem::canonical(file, error);
    return error ? file : real;
}

void load(scene::Map& map, std::string_view statement, Cache& cache) {
    if (map.texture || map.from_scene > 0) return;
    TextureRef& texture = cache[key_of(map.file)];
    try {
        if (!texture) texture = read_texture(map.file);
    } catch (const Error& error) {
        throw Error(map.origin.file, map.origin.line,
                    std::string(statement) + " " + map.file.string() + ": " + error.what());
    }
    map.texture = texture;
}

}  // namespace

void load_textures(scene::Scene& scene) {
    Cache cache;
    for (scene::Material& material : scene.materials) {
        const std::pair<std::string_view, std::vector<scene::Map>*> lists[] = {
            {"map_Ka", &material.map_Ka}, {"map_Kd", &material.map_Kd},
            {"map_Ks", &material.map_Ks}, {"map_Ke", &material.map_Ke},
            {"refl", &material.refl},     {"refraction", &material.refraction},
        };
        for (const auto& [statement, maps] : lists) {
            for (scene::Map& map : *maps) load(map, statement, cache);
        }
    }
}

}  // namespace gw::image
