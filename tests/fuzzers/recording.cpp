// Reads any bytes as a recording. Claim: they are refused with an Error, or they are a recording
// that encoding and decoding return unchanged. If it is small, both machines replay it to the same
// planes; without the fast machine, only the reference machine replays it.
#include "gw/error.h"
#include "inspect/replay/player.h"

#include <cstdlib>

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 262144) return -1;
    const inspect::Limits limits{
        .decoded_bytes = 64 << 20, .machine_bytes = 64 << 20, .geometry = std::uint64_t{1} << 24};
    try {
        const inspect::Recording recording = inspect::decode({data, size}, limits);
        const auto bytes = inspect::encode(recording);
        if (inspect::encode(inspect::decode(bytes, limits)) != bytes) std::abort();
        if (is_small(recording)) replay(recording);
    } catch (const Error&) {
    }
    return 0;
}
