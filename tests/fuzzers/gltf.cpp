// Any bytes as glTF 2.0: a GLB if they begin with its magic, else JSON. Claim: reading, cutting by
// opacity and posing an animation ends with a scene or with an Error of one line.
#include "gw/error.h"
#include "scene/maps/finish.h"
#include "scene/toml/read_scene.h"
#include "tests/fuzzers/scene_folder.h"

#include <cstdint>

namespace {

/// Gives maps a texture whose texels all differ; pictures are another reader's.
void paint(gw::scene::Material& material) {
    static const gw::TextureRef texture = [] {
        std::vector<std::uint8_t> rgba;
        for (int i = 0; i < 4 * 8 * 4; ++i) rgba.push_back(std::uint8_t(i * 83));
        return gw::make_texture8("texels", 8, 4, rgba);
    }();
    for (auto* maps : {&material.map_Kd, &material.map_Ke, &material.map_d, &material.map_metal})
        for (gw::scene::Map& map : *maps)
            if (!map.texture) map.texture = texture;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gw;
    if (size > 65536) return -1;
    static const fuzzers::SceneFolder folder;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto file = folder.write(bytes.starts_with("glTF") ? "s.glb" : "s.gltf", bytes);
    try {
        scene::SceneFile read = scene::read_scene(file);
        for (scene::Material& material : read.scene.materials) paint(material);
        scene::Warnings warnings;
        scene::finish(read.scene, read.films, warnings);
        for (const scene::Film& film : read.films) film.pose(read.scene, film.seconds / 2);
    } catch (const Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
