// What was traced, counted by kind. [K4f] Sums are the same for any number of threads.
#pragma once

#include <cstdint>

namespace gw::raytrace {

struct RayCounts {
    std::uint64_t primary = 0;      ///< from the eye
    std::uint64_t reflected = 0;    ///< from any hit
    std::uint64_t transmitted = 0;  ///< from any hit
    std::uint64_t shadow = 0;       ///< towards lights
    std::uint64_t shaded = 0;       ///< points at which eq. 3 was evaluated

    void add(const RayCounts& c) {
        primary += c.primary;
        reflected += c.reflected;
        transmitted += c.transmitted;
        shadow += c.shadow;
        shaded += c.shaded;
    }
    bool operator==(const RayCounts&) const = default;
};

}  // namespace gw::raytrace
