// Marble: veins lie at the level of warped noise.
#include "scenes/make_maps/materials.h"
#include "scenes/make_maps/noise.h"

#include <cmath>

namespace gw::maps {
namespace {

// The place that noise pushes st to; still repeats.
dvec2 warped(dvec2 st, double strength, std::uint32_t seed) {
    return st + strength * dvec2(fractal(st, {3, 3}, 4, seed) - 0.5,
                                 fractal(st, {3, 3}, 4, seed + 100) - 0.5);
}

// 1 on the middle line of a vein, falling to 0 at `width` of the noise's range from it.
double vein(dvec2 st, ivec2 cells, double width, std::uint32_t seed) {
    return 1 - ramp(0, width, std::abs(fractal(st, cells, 4, seed) - 0.5));
}

double veins(dvec2 st) {
    const dvec2 p = warped(st, 0.35, 11);
    const double broad = vein(p, {2, 3}, 0.026, 21), fine = vein(p, {5, 4}, 0.018, 31);
    return std::max(broad, 0.6 * fine);
}

}  // namespace

Color marble(dvec2 st) {
    const double cloud = fractal(warped(st, 0.2, 41), {4, 4}, 5, 51);
    const Color ground = mix({0.05, 0.22, 0.16}, {0.22, 0.46, 0.34}, ramp(0.25, 0.75, cloud));
    return mix(ground, {0.86, 0.9, 0.82}, veins(st));
}

Color marble_gloss(dvec2 st) { return grey(1 - 0.92 * ramp(0.05, 0.6, veins(st))); }

Color white_marble(dvec2 st) {
    const dvec2 p = warped(st, 0.4, 61);
    const double cloud = fractal(p, {3, 3}, 5, 71), dark = vein(p, {2, 2}, 0.03, 81);
    return mix(mix({0.93, 0.92, 0.9}, {0.74, 0.74, 0.77}, ramp(0.45, 0.8, cloud)),
               {0.45, 0.45, 0.5}, 0.8 * dark);
}

Color granite(dvec2 st) {
    const double fine = fractal(st, {48, 48}, 3, 91), coarse = fractal(st, {12, 12}, 3, 95);
    const Color ground = mix({0.42, 0.4, 0.42}, {0.66, 0.63, 0.62}, ramp(0.3, 0.7, coarse));
    return mix(mix(ground, {0.16, 0.16, 0.18}, ramp(0.62, 0.7, fine)), {0.88, 0.84, 0.82},
               ramp(0.36, 0.28, fine));
}

}  // namespace gw::maps
