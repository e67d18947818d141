// Any bytes as an OBJ file; the bytes after the line "#mtl" are the MTL file m.mtl beside it.
// Claim: reading ends with a scene or with an Error of one line.
#include "gw/error.h"
#include "scene/toml/read_scene.h"
#include "tests/fuzzers/scene_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gw;
    if (size > 65536) return -1;
    static const fuzzers::SceneFolder folder;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    constexpr std::string_view separator = "\n#mtl\n";
    const std::size_t end = text.find(separator);
    const auto obj = folder.write("s.obj", text.substr(0, end));
    folder.write("m.mtl", end == text.npos ? "" : text.substr(end + separator.size()));
    try {
        scene::read_scene(obj);
    } catch (const Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
