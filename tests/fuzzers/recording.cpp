// Reads any bytes as a recording or a stream. Claim: they are refused with an Error, or each of
// their recordings is one that encoding and decoding return unchanged. If it is small, both
// machines replay it to the same planes; without the fast machine, only the reference machine
// replays it.
#include "gw/error.h"
#include "inspect/recording/stream.h"
#include "inspect/replay/player.h"

#include <cstdlib>
#include <sstream>
#include <string>

namespace {

using namespace gw;

/// Cheap enough to replay: few pixels, few primitives, commands that touch each pixel a few times.
bool is_small(const inspect::Recording& recording) {
    std::size_t cost = 1;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) {
            ++cost;
            if (const auto* draw = std::get_if<Draw>(&command))
                cost += draw->mesh->triangles().size() + draw->mesh->lines().size() +
                        draw->mesh->points().size();
            if (const auto* draw = std::get_if<DrawPixels>(&command)) cost += draw->area();
        }
    return cost * std::size_t(recording.width) * std::size_t(recording.height) <= 20000;
}

void replay(const inspect::Recording& recording) {
    const auto reference = make_reference(recording.profile, recording.width, recording.height);
    inspect::Player(recording, *reference).play();
#ifdef GW_WITH_FAST
    const auto fast =
        make_fast(recording.profile, recording.width, recording.height, {.threads = 1});
    inspect::Player(recording, *fast).play();
    if (reference->planes() != fast->planes()) std::abort();
#endif
}

void check(const inspect::Recording& recording, const inspect::Limits& limits) {
    const auto bytes = inspect::encode(recording);
    if (inspect::encode(inspect::decode(bytes, limits)) != bytes) std::abort();
    if (is_small(recording)) replay(recording);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 262144) return -1;
    const inspect::Limits limits{
        .decoded_bytes = 64 << 20, .machine_bytes = 64 << 20, .geometry = std::uint64_t{1} << 24};
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        if (!inspect::is_stream(bytes)) {
            check(inspect::decode({data, size}, limits), limits);
        } else {
            std::istringstream in(bytes);
            for (const auto& window : inspect::decode_stream(in, limits).windows)
                check(window.recording, limits);
        }
    } catch (const Error&) {
    }
    return 0;
}
