#include "scenes/make_maps/noise.h"

#include <cmath>

namespace gw::maps {
namespace {

std::uint32_t mix(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return h ^ (h >> 16);
}

int wrapped(int i, int n) { return ((i % n) + n) % n; }

double smooth(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double between(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return mix(x + mix(y + mix(seed)));
}

double hash_unit(int x, int y, std::uint32_t seed) {
    return hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed) * 0x1p-32;
}

double noise(dvec2 st, ivec2 cells, std::uint32_t seed) {
    const dvec2 p{st.x * cells.x, st.y * cells.y}, low{std::floor(p.x), std::floor(p.y)};
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    const auto at = [&](int i, int j) {
        return hash_unit(wrapped(i, cells.x), wrapped(j, cells.y), seed);
    };
    const double u = smooth(p.x - low.x), v = smooth(p.y - low.y);
    return between(between(at(x, y), at(x + 1, y), u), between(at(x, y + 1), at(x + 1, y + 1), u),
                   v);
}

double fractal(dvec2 st, ivec2 cells, int octaves, std::uint32_t seed) {
    double sum = 0, strength = 1, total = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += strength * noise(st, cells, seed + static_cast<std::uint32_t>(i));
        total += strength;
        strength /= 2;
        cells *= 2;
    }
    return sum / total;
}

}  // namespace gw::maps
