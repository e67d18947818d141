#include "gw/counter_names.h"

namespace gw {

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

}  // namespace gw
