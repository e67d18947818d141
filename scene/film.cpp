#include "scene/film.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

/// [GLTF2 C.5]: Hermite's cubic from p to q in a time of `span`, with slopes a and b.
double hermite(double t, double span, double p, double a, double q, double b) {
    const double t2 = t * t, t3 = t2 * t;
    return ((2 * t3 - 3 * t2 + 1) * p + span * (t3 - 2 * t2 + t) * a) +
           ((3 * t2 - 2 * t3) * q + span * (t3 - t2) * b);
}

}  // namespace

std::vector<double> Keys::at(double time) const {
    const auto value = [&](std::size_t key, std::size_t k) { return values[key * width + k]; };
    const auto slope = [&](const std::vector<double>& given, std::size_t key, std::size_t k) {
        if (!given.empty()) return given[key * width + k];
        const std::size_t before = key == 0 ? 0 : key - 1;
        const std::size_t after = std::min(key + 1, times.size() - 1);
        return (value(after, k) - value(before, k)) / (times[after] - times[before]);
    };
    const auto after = std::ranges::upper_bound(times, time);
    const std::size_t to = std::size_t(after - times.begin());
    const std::size_t from = to == 0 ? 0 : to - 1;
    std::vector<double> out;
    for (std::size_t k = 0; k < width; ++k) {
        const double p = value(from, k);
        if (to == 0 || to == times.size() || interpolation == Interpolation::Step) {
            out.push_back(p);
            continue;
        }
        const double q = value(to, k), span = times[to] - times[from];
        const double t = (time - times[from]) / span;
        out.push_back(
            interpolation == Interpolation::Linear
                ? p + t * (q - p)
                : hermite(t, span, p, slope(slopes_out, from, k), q, slope(slopes_in, to, k)));
    }
    return out;
}

int Film::pictures() const { return 1 + int(std::floor(std::min(seconds * rate + 1e-9, 1e6))); }

std::vector<double> Film::instants_of(int picture) const {
    const double time = time_of(picture);
    if (shutter == 0) return {time};
    std::vector<double> all;
    for (int i = 0; i < instants; ++i)
        all.push_back(time + shutter / rate * ((i + 0.5) / instants - 0.5));
    return all;
}

}  // namespace gw::scene
