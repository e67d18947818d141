#include "apps/counters_table.h"

namespace gw::apps {

std::span<const CounterName> counter_names() {
    static constexpr CounterName names[] = {
        {"draws", &Counters::draws},
        {"vertices", &Counters::vertices},
        {"primitives", &Counters::primitives},
        {"rejected", &Counters::rejected},
        {"clipped", &Counters::clipped},
        {"degenerate", &Counters::degenerate},
        {"culled", &Counters::culled},
        {"drawn", &Counters::drawn},
        {"fragments", &Counters::fragments},
        {"alpha_killed", &Counters::alpha_killed},
        {"stencil_killed", &Counters::stencil_killed},
        {"depth_killed", &Counters::depth_killed},
        {"written", &Counters::written},
        {"texels", &Counters::texels},
        {"pixels", &Counters::pixels},
        {"accum_overflows", &Counters::accum_overflows},
        {"bytes", &Counters::bytes},
    };
    static_assert(sizeof(names) / sizeof(CounterName) * sizeof(std::uint64_t) == sizeof(Counters));
    return names;
}

nlohmann::ordered_json json_of(const Counters& counters) {
    nlohmann::ordered_json json;
    for (const auto& [name, count] : counter_names()) json[name] = counters.*count;
    return json;
}

}  // namespace gw::apps
