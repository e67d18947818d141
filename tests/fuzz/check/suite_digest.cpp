// FNV-1a over the text of digests and counters.
#include "tests/fuzz/check/suite_digest.h"

#include "gw/names.h"

#include <fmt/format.h>

namespace gw::fuzz {
namespace {

std::string fnv(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return fmt::format("{:016x}", h);
}

std::string text_of(const Counters& counters) {
    std::string out;
    for (const CounterName& c : counter_names()) out += fmt::format(" {}", counters.*c.count);
    return out;
}

}  // namespace

std::string counters_digest(const Counters& counters) { return fnv(text_of(counters)); }

std::string suite_digest(const Suite& suite, std::uint64_t low, std::uint64_t high,
                         const MachineMaker& make) {
    std::string all;
    for (std::uint64_t i = low; i < high; ++i) {
        const Case c = make_case(suite, i);
        const auto machine = make(c, 0);
        machine->execute(c.list);
        for (const Plane plane : every_plane)
            if (plane != Plane::Back || (suite.planes & mask_of(plane)))
                all += to_string(digest(machine->planes(), plane));
        for (const PassReport& pass : machine->passes()) all += text_of(pass.counters);
    }
    return fnv(all);
}

}  // namespace gw::fuzz
