// f = (end - z) / (end - start), exp(-density z), exp(-(density z)^2). [GL11] 3.10
#include "gw/stages/fog.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"

#include <algorithm>
#include <cmath>

namespace gw {

bool fog_is_per_fragment(const FogState& fog, const Profile& profile) {
    if (fog.coordinate == FogCoordinate::Profile) return profile.fragment_fog;
    return fog.coordinate == FogCoordinate::Fragment;
}

std::uint32_t fog_factor(const FogState& fog, double z, int bits) {
    const double depth = double(fog.density) * z;
    double f = 0;
    switch (fog.mode) {
        case FogMode::Linear:
            f = (double(fog.end) - z) / (double(fog.end) - double(fog.start));
            break;
        case FogMode::Exp: f = exp(-depth); break;
        case FogMode::Exp2: f = exp(-(depth * depth)); break;
    }
    return quantize(f, bits);
}

double fog_table_depth(const FogState& fog, int bits) {
    constexpr double ln2 = 0.693147180559945309417;
    switch (fog.mode) {
        case FogMode::Linear: return std::max({double(fog.start), double(fog.end), 1e-30});
        // the distance at which exp(-density z) falls below half a unit
        case FogMode::Exp: return ((bits + 1) * ln2) / fog.density;
        case FogMode::Exp2: return std::sqrt((bits + 1) * ln2) / fog.density;
    }
    return 1;
}

double fog_unit(const FogState& fog, int bits) {
    if (fog.source == FogSource::Coordinate && fog.mode == FogMode::Linear)
        return std::abs(double(fog.end) - double(fog.start));
    return fog_table_depth(fog, bits);
}

std::uint32_t direct_fog_factor(const FogState& fog, double k, double u, int exponent, int bits) {
    return fog_factor(fog, fog_unit(fog, bits) * (k + std::ldexp(u, exponent)), bits);
}

std::vector<std::uint32_t> fog_table(const FogState& fog, int bits) {
    const int steps = 1 << fog_table_log2(bits);
    const double step = fog_table_depth(fog, bits) / steps;
    std::vector<std::uint32_t> table;
    for (int i = 0; i <= steps; ++i) table.push_back(fog_factor(fog, i * step, bits));
    return table;
}

}  // namespace gw
