// The snap may make a corner of a convex polygon slightly reflex. No piece of the fan from that
// corner is turned over.
#include "gw/stages/fan.h"

namespace gw {
namespace {

std::int64_t piece_area2(std::span<const SnappedPoint> p, std::size_t first, std::size_t k) {
    const auto at = [&](std::size_t i) { return p[i < p.size() ? i : i - p.size()]; };
    return area2(p[first], at(first + k), at(first + k + 1));
}

bool turns_none_over(std::span<const SnappedPoint> p, std::size_t first, bool counter_clockwise) {
    for (std::size_t k = 1; k + 1 < p.size(); ++k) {
        const std::int64_t area = piece_area2(p, first, k);
        if (area != 0 && (area > 0) != counter_clockwise) return false;
    }
    return true;
}

}  // namespace

Fan fan_of(std::span<const SnappedPoint> p) {
    Fan fan;
    for (std::size_t k = 1; k + 1 < p.size(); ++k) fan.area2 += piece_area2(p, 0, k);
    for (std::size_t first = 0; first < p.size() && p.size() > 3; ++first)
        if (turns_none_over(p, first, fan.area2 > 0)) {
            fan.first = first;
            break;
        }
    return fan;
}

}  // namespace gw
