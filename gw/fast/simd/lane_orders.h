// The orders of eight lanes by a mask of them. Does not move lanes.
#pragma once

#include <cstdint>

namespace gw::fast {

struct LaneOrders {
    std::uint8_t packed[256][8];  ///< the mask's lanes, lowest first, then lane 0
    std::uint8_t spread[256][8];  ///< of each lane, how many lanes of the mask are below it
};

constexpr LaneOrders make_lane_orders() {
    LaneOrders out{};
    for (unsigned mask = 0; mask < 256; ++mask) {
        unsigned count = 0;
        for (unsigned lane = 0; lane < 8; ++lane) {
            out.spread[mask][lane] = static_cast<std::uint8_t>(count);
            if (mask >> lane & 1) out.packed[mask][count++] = static_cast<std::uint8_t>(lane);
        }
    }
    return out;
}
alignas(64) inline constexpr LaneOrders lane_orders = make_lane_orders();

}  // namespace gw::fast
