#include "gl/record/estimate.h"

#include "generated/gl/vgx_prices.h"

#include <algorithm>

namespace gw::gl {

namespace {

double seconds(const Counters& frame, double Price::*nanoseconds) {
    double geometry = 0, pixels = 0;
    for (const Price& price : vgx_prices)
        (price.is_geometry ? geometry : pixels) += double(frame.*price.count) * price.*nanoseconds;
    return std::max(geometry, pixels) / 1e9;
}

}  // namespace

Estimate& Estimate::operator+=(const Estimate& other) {
    seconds += other.seconds;
    least += other.least;
    most += other.most;
    return *this;
}

const char* estimated_machine() { return priced_machine; }

Estimate estimated_on_vgx(const Counters& frame) {
    return {seconds(frame, &Price::nanoseconds), seconds(frame, &Price::low),
            seconds(frame, &Price::high)};
}

}  // namespace gw::gl
