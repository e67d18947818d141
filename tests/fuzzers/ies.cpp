// Any bytes as an IES file. Claim: reading ends with an Error of one line, or with intensities that are
// finite and at least 0 in every direction.
#include "gw/error.h"
#include "scene/read_ies.h"
#include "tests/fuzzers/scene_folder.h"

#include <cmath>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace gw;
    if (size > 65536) return -1;
    static const fuzzers::SceneFolder folder;
    const auto file =
        folder.write("l.ies", std::string_view(reinterpret_cast<const char*>(data), size));
    try {
        scene::Warnings warnings;
        const scene::Photometry web = scene::read_ies(file, warnings);
        if (!(web.lumen() >= 0)) std::abort();
        for (double vertical = 0; vertical <= 180; vertical += 22.5)
            for (double horizontal = 0; horizontal < 360; horizontal += 30) {
                const double candela = web.at(vertical, horizontal);
                if (!(candela >= 0) || !std::isfinite(candela)) std::abort();
            }
    } catch (const Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
