// Any bytes as a TOML scene. Claim: reading ends with a scene or with an Error of one line.
#include "gw/error.h"
#include "scene/toml/read_scene.h"
#include "tests/fuzzers/scene_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gw;
    if (size > 65536) return -1;
    static const fuzzers::SceneFolder folder;
    const auto file = folder.write("s.toml", {reinterpret_cast<const char*>(data), size});
    try {
        scene::read_scene(file);
    } catch (const Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
