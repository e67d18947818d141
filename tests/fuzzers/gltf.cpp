// Any bytes as glTF 2.0: a GLB if they begin with its magic, else JSON. Claim: reading, and
// posing an animation, ends with a scene or with an Error of one line.
#include "gw/error.h"
#include "scene/toml/read_scene.h"
#include "tests/fuzzers/scene_folder.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gw;
    if (size > 65536) return -1;
    static const fuzzers::SceneFolder folder;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto file = folder.write(bytes.starts_with("glTF") ? "s.glb" : "s.gltf", bytes);
    try {
        scene::SceneFile read = scene::read_scene(file);
        if (read.film) read.film->pose(read.scene, read.film->seconds / 2);
    } catch (const Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
