// The fog factor at a vertex, and the table of factors per fragment. docs/manual/fog.md.
// Does not blend: tables.h does.
#pragma once

#include "gw/profile.h"
#include "gw/state.h"

#include <cstdint>
#include <vector>

namespace gw {

/// Whether the factor is computed per fragment, by the state or by the profile. [K] Fig. 2
bool fog_is_per_fragment(const FogState& fog, const Profile& profile);

/// Whether it is computed at each fragment, without a table: from a given coordinate.
constexpr bool fog_is_direct(const FogState& fog, bool per_fragment) {
    return per_fragment && fog.source == FogSource::Coordinate;
}

/// The factor at distance z as a fraction of `bits` bits: 1 without fog, 0 in full fog.
std::uint32_t fog_factor(const FogState& fog, double z, int bits);

/// Steps of the fragment table as a power of two: 256, or 1024 above 8 bits.
constexpr int fog_table_log2(int bits) { return bits == 8 ? 8 : 10; }

/// The eye distance of the table's last entry. Beyond, the factor is constant.
double fog_table_depth(const FogState& fog, int bits);

/// The distance that is 1 in the fog values of vertices, if the factor is computed per fragment.
double fog_unit(const FogState& fog, int bits);

/// The factor at the coordinate k + u 2^exponent, in units of fog_unit().
std::uint32_t direct_fog_factor(const FogState& fog, double k, double u, int exponent, int bits);

/// Factors at i * fog_table_depth / steps, i = 0 .. steps.
std::vector<std::uint32_t> fog_table(const FogState& fog, int bits);

}  // namespace gw
