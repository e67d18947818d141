#include "hiddensurface/run/counts.h"

namespace gw::hiddensurface {

std::span<const CountName> count_names() {
    static constexpr CountName names[] = {
        {"polygons", &Counts::polygons},
        {"facings", &Counts::facings},
        {"keys", &Counts::keys},
        {"extents", &Counts::extents},
        {"planes", &Counts::planes},
        {"overlaps", &Counts::overlaps},
        {"crossings", &Counts::crossings},
        {"depths", &Counts::depths},
        {"rays", &Counts::rays},
        {"sorts", &Counts::sorts},
        {"swaps", &Counts::swaps},
        {"splits", &Counts::splits},
        {"undecided", &Counts::undecided},
        {"rejected", &Counts::rejected},
        {"nodes", &Counts::nodes},
        {"spans", &Counts::spans},
        {"peak_bytes", &Counts::peak_bytes},
        {"fragments", &Counts::fragments},
        {"passed", &Counts::passed},
        {"pixels", &Counts::pixels},
        {"overdraw", &Counts::overdraw},
        {"ties", &Counts::ties},
        {"edges", &Counts::edges},
        {"snapped", &Counts::snapped},
        {"wrong", &Counts::wrong},
    };
    static_assert(sizeof(names) / sizeof(CountName) * sizeof(std::uint64_t) == sizeof(Counts));
    return names;
}

}  // namespace gw::hiddensurface
