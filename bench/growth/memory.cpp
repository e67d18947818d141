#include "bench/growth/memory.h"

#include "bench/draws/field.h"
#include "gw/machine.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace gw::growth {
namespace {

double resident_megabytes() {
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// Three draws of meshes and a texture that no frame before had; sizes differ from frame to frame.
CommandList frame(const draws::Ours& field, int number) {
    CommandList list = field.draws(draws::Own::Nothing, 1e-9 * number);
    const int side = 8 << number % 4;
    std::vector<std::uint8_t> rgba(std::size_t(4 * side * side), std::uint8_t(number & 255));
    const TextureRef texture = make_texture8("frame", side, side, rgba);
    for (Command& command : list.commands)
        if (Draw* draw = std::get_if<Draw>(&command)) draw->map.texture = texture;
    return list;
}

}  // namespace

std::vector<dvec2> memory_by_frame(int frames, const std::function<void(int)>& progress) {
    const auto machine = make_fast(vgx(), 64, 64, {.threads = 1});
    const std::vector<draws::Ours> fields{draws::Ours(3), draws::Ours(30), draws::Ours(10)};
    const int every = std::max(frames / 100, 1);
    std::vector<dvec2> samples;
    for (int i = 0; i < frames; ++i) {
        machine->execute(frame(fields[std::size_t(i) % fields.size()], i));
        machine->reset_passes();
        if (i % every != every - 1) continue;
        samples.push_back({double(i + 1), resident_megabytes()});
        progress(i + 1);
    }
    return samples;
}

}  // namespace gw::growth
