// The time that a frame would have taken on the papers' machine, by the price list
// inspect/report/prices/vgx.toml. An estimate. Does not read the list: the build makes a table of it.
#pragma once

#include "gw/counters.h"

#include <cstdint>

namespace gw::gl {

/// Nanoseconds for one, and their limits. The stages geometry and pixels work at the same time.
struct Price {
    std::uint64_t Counters::*count;
    bool is_geometry;
    double nanoseconds, low, high;
};

/// In seconds; least and most: all prices at their limits.
struct Estimate {
    double seconds = 0, least = 0, most = 0;
    Estimate& operator+=(const Estimate& other);
};

/// "IRIS 4D/340 VGX ..."
const char* estimated_machine();
/// Of a frame: the time of its slower stage.
Estimate estimated_on_vgx(const Counters& frame);

}  // namespace gw::gl
